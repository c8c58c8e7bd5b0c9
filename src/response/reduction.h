// The reduced model of a compiled scene.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fem/compile.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Times at which a reduced model answers a scene: steps of at most a 32nd of the loads' shortest duration, or those
/// that the case gives where straight lines between them are the loads; they meet all kinks, and the samples of
/// measured records.
std::vector<double> response_times(const Scene& scene, const System& system);

std::vector<TimeFunction> load_histories(const System& system);

/// The scene's own loads at those times, and at others that are asked for.
SampledLoads sampled_loads(const Scene& scene, const System& system, const std::vector<double>& others = {});

/// Which of a series' times tell the extremes of what moves with the loads: about 16 in the shortest `duration` (s).
std::vector<Eigen::Index> looks_at(const std::vector<double>& time, double duration);

/// What a model is to be good for.
struct ReductionTargets {
  bool only_shear = false;          ///< F_T, and `states` where they are asked for, not all readings
  bool each_load = false;           ///< any history of each load, not only what they do together in the scene
  std::optional<int> most_vectors;  ///< per independent load, where the default is not meant
  bool pressures = false;           ///< to be told everywhere, not at probes alone: Reduction::pressures
  bool states = false;              ///< all that moves is: Reduction::states
  /// The forces on an elastic caisson balance to round-off, not to the model's error: its rigid motions are kept, which
  /// takes half as many vectors more.
  bool balanced = false;
  /// That readings besides F_T are to meet 10 or 20 times of; the scene's own where none is given.
  std::optional<double> tolerance_of_others = std::nullopt;
};

/// The shift of a scene's Krylov space (1/s): 1.25 times 2 pi over the shortest duration of its loads, 1.75 times where
/// a soil has no material damping. Measured in docs/reduced.md.
double krylov_shift(const Scene& scene);

/// What reduce_scene() reduces a scene by.
ReduceOptions reduce_options(const Scene& scene, const CompiledScene& compiled, const ReductionTargets& targets);

/// Reduces a scene for all its loads, at krylov_shift. The history of F_T must meet the scene's tolerance, all other
/// readings, unless only F_T is aimed at, 10 times as much, 20 times where a soil is not damped. Without a caisson all
/// readings meet the tolerance. It is the smaller of two nested models that misses by so much; the larger one, which is
/// kept, is better where the space converges quickly, and about as good where it does not. `progress`: called with 0 to
/// 1 after every solve. Throws NumericsError.
Reduction reduce_scene(const Scene& scene, const CompiledScene& compiled, const ReductionTargets& targets,
                       const std::function<void(double)>& progress = {});

/// Name of the reading with the largest error; "" where there is none.
std::string worst_reading(const Reduction& reduction);

/// Throws NumericsError with the error reached where the models did not come close enough.
void require_converged(const Reduction& reduction);

/// The same of F_T alone: other readings may not have come close enough.
void require_shear_converged(const Reduction& reduction);

/// Those besides F_T, in the order of the readings; none of a model that has converged.
std::vector<LooseReading> loose_readings(const Reduction& reduction);

/// Largest difference of F_T between the model and a march with the same steps, over its peak: how wrong the model
/// truly is for the scene's own loads. Takes as long as marching with steps of a 32nd of the duration.
double error_against_march(const Reduction& reduction, const Scene& scene, const CompiledScene& compiled);

/// What the model answers to the scene's own loads, as a march would have found it, but without an account of energy.
Response respond(const Reduction& reduction, const Scene& scene, const System& system);

}  // namespace upbead
