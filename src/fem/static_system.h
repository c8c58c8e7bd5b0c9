// The ground at rest under its weight, for any stiffness.
#pragma once

#include "fem/static_stage.h"
#include "upbead/algebra/sparse.h"
#include "upbead/fem/soil_state.h"

namespace upbead::detail {

class StaticSystem {
 public:
  /// The mesh must outlive it.
  StaticSystem(const Scene& scene, const Mesh& mesh);
  /// Effective stresses of drained soils with that stiffness.
  EffectiveStress solve(const SoilState& soil) const;

 private:
  Scene scene_;  ///< no pressures, no waves, nothing that leaves
  const Mesh& mesh_;
  Vector weights_;  ///< by unknown; whatever the stiffness
};

/// See static_normal_forces and caisson_in_water.
Vector normal_forces(const Scene& scene, const Mesh& mesh, const SoilState& soil, bool has_settled);
WeightInWater caisson_in_water(const Scene& scene, const Mesh& mesh);

}  // namespace upbead::detail
