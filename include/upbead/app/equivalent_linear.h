// Soils whose stiffness and damping follow the strain of the response: iterated linear solutions.
#pragma once

#include <functional>

#include "upbead/app/pipeline.h"

namespace upbead {

/// Whether a region of the scene has a strain law.
bool needs_equivalent_linear(const Scene& scene);

/// Marches the scene with the stiffness and damping of every cell, finds the cells' largest shear strains, takes what
/// their effective part says of stiffness and damping, and begins anew until the peak of F_T (without a caisson: the
/// largest strain) changes by less than 1 %, or 15 times. `scene` then is compiled with the last soil and tells what
/// came out in `scene.soil`. Seed and Idriss (1969); Schnabel, Lysmer and Seed (1972). Does nothing where no region has
/// a strain law, or where it has been done. `progress` is called in every step with 0 to 1. Throws NumericsError.
void settle_soil(const Case& input, CompiledCase& scene, const std::function<void(double)>& progress);

}  // namespace upbead
