// The reduced model of a compiled scene.
#pragma once

#include <vector>

#include "upbead/dynamics/reduce.h"
#include "upbead/fem/compile.h"

namespace upbead {

/// Times at which a reduced model answers a scene: steps of at most a 32nd of the loads' shortest duration, or those
/// that the case gives, which meet all kinks, and the samples of measured records.
std::vector<double> response_times(const Scene& scene, const System& system);

/// Reduces a scene for all its loads. The shift is 1.25 times 2 pi over their shortest duration (1/s). The history of
/// F_T must meet the scene's tolerance, all other readings, unless `only_shear`, ten times as much. Without a caisson
/// all readings meet the tolerance. As it is the smaller of two nested models that misses by so much, the larger one,
/// which is kept, is better. Throws NumericsError.
Reduction reduce_scene(const Scene& scene, const CompiledScene& compiled, bool only_shear = false);

/// Throws NumericsError with the error reached where the models did not come close enough.
void require_converged(const Reduction& reduction);

/// Largest difference of F_T between the model and a march with the same steps, over its peak: how wrong the model
/// truly is for the scene's own loads. Takes as long as marching with steps of a 32nd of the duration.
double error_against_march(const Reduction& reduction, const Scene& scene, const CompiledScene& compiled);

/// What the model answers to the scene's own loads, as a march would have found it, but without an account of energy.
Response respond(const Reduction& reduction, const Scene& scene, const System& system);

}  // namespace upbead
