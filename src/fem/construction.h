// Construction in stages: what stands in each, and how the ground answers to it, drained.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fem/ground.h"
#include "fem/static_soil.h"

namespace upbead {

/// A stage as a scene at rest. Cells that do not stand yet are water there, without weight and stiffness. Elements are
/// born without stress: displacements count from the begin of each stage.
struct Stage {
  std::string name;      ///< "" where the scene is not built in stages
  Scene scene;           ///< the result of at_rest()
  double level = 0.;     ///< of still water (m)
  bool is_first = true;  ///< the ground as it is found
};

/// The stages of a scene in their order; one with everything where it is not built in stages. Surcharges, and a level
/// of the harbour, come with the last one.
std::vector<Stage> stages_of(const Scene& scene, const Mesh& mesh);

/// A stage when it is done.
struct BuiltStage {
  std::string name;
  double weight = 0.;                          ///< of all that stands, in water (N/m)
  PointStresses stresses;                      ///< effective
  std::vector<std::array<double, dim>> moved;  ///< in this stage, by vertex (m), see Ground::moved; empty: not known
  std::optional<BaseResultant> base;           ///< of a rigid caisson that stands
  std::optional<std::array<double, n_motions>> caisson;  ///< its motion in this stage, likewise
  double share_at_strength = 0.;                         ///< see StaticSoil
};

/// What the weights of a stage add to those that `before` bears: nodal forces. `before`: stresses of the last stage, or
/// empty.
Vector added_weights(const Stage& stage, const Ground& ground, const PointStresses& before);

/// The stresses of elastic ground after displacements x from stresses `before`.
PointStresses stresses_after(const Ground& ground, const PointStresses& before, const Vector& x);

}  // namespace upbead
