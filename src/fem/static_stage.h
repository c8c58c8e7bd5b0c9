// The static state before the waves: soils under their submerged weight, with the caisson on them.
#pragma once

#include <optional>
#include <vector>

#include "upbead/algebra/sparse.h"
#include "upbead/fem/soil_state.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Effective stresses at the middle of each active cell, compression positive (Pa); 0 where there is no soil.
struct EffectiveStress {
  std::vector<double> horizontal, vertical, out_of_plane;
  std::vector<double> shear;  ///< -sigma_xy
  /// (s'_x + s'_y + s'_z) / 3 of a cell; (1 + 2 K_0)/3 s'_y if K_0 is given.
  double mean(std::size_t cell, const std::optional<double>& k0) const;
};

struct StaticStage {
  EffectiveStress stress;
  std::vector<double> shear_modulus;  ///< by active cell index; 0 where no law depends on stress (Pa)
  int iterations = 0;                 ///< solves until no G changed by more than 0.1 %
  double weight = 0.;                 ///< norm of the nodal forces of all weights (N/m)
  /// G of the cells in every stage of construction, as `shear_modulus`; empty where it is not built in stages.
  std::vector<std::vector<double>> in_stages{};
};

/// Whether a region's stiffness depends on stress.
bool needs_static_stage(const Scene& scene);

/// The key k0 of [initial].
std::optional<double> k0_of(const Scene& scene);

/// K_0 by which horizontal stresses of a StaticStage follow from its vertical ones: that key. None where the section is
/// built in stages: these stresses have it already, in the ground of the first stage.
std::optional<double> k0_to_apply(const Scene& scene);

/// Height of still water (m): [initial] water_level, else the top of the water regions, else -infinity.
double water_level(const Scene& scene, const Mesh& mesh);

/// Normal forces N_i of the static state at the interface_nodes under a rigid caisson (N/m, compression positive),
/// with the soils' stiffness in that state. The bottom is bonded; its shear stress is taken to have crept away. The
/// sum of N_i is the weight of the caisson in still water. The caisson stood there when the soils settled under their
/// own weight, or, where the ground `has_settled`, was set down after that. Of a scene that is built in stages: of what
/// was built when it was set down, whatever `has_settled` says. Throws NumericsError where the ground is
/// not held.
Vector static_normal_forces(const Scene& scene, const Mesh& mesh, const SoilState& soil, bool has_settled = false);

/// Weight of a rigid caisson in still water (N/m), and the point where it acts (m, along x).
struct WeightInWater {
  double weight = 0.;
  double x = 0.;
};
WeightInWater caisson_in_water(const Scene& scene, const Mesh& mesh);

/// Solves div sigma' + gamma' = 0 for drained soils on the scene's own supports, with absorbing sides as rollers.
/// Unit weights: gamma' = (1 - n)(rho_s - rho_f) g below still water and (1 - n) rho_s g above it; for bodies
/// (rho - rho_f) g and rho g. With the surcharges of [initial]. G follows the stress until it settles. Where the scene
/// is built in stages, stresses are the sums of what each stage adds, see fem/construction.h; G is that of the stress
/// at the stage's end. Throws NumericsError where it does not settle, or the ground is not held.
StaticStage solve_static(const Scene& scene, const Mesh& mesh);

}  // namespace upbead
