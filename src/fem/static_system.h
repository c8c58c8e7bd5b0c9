// One linear solve of the static state.
#pragma once

#include "upbead/fem/soil_state.h"
#include "upbead/fem/static_stage.h"

namespace upbead::detail {

/// Effective stresses of drained soils under their weight, with given stiffness.
EffectiveStress static_stress(const Scene& scene, const Mesh& mesh, const SoilState& soil);

}  // namespace upbead::detail
