// Readings of the caisson: forces at its bottom by two routes, its motion; and stress, pore pressure and displacement
// along its bottom.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "fem/caisson/caisson.h"
#include "fem/caisson/reading_names.h"
#include "fem/scene_loads.h"
#include "upbead/system/system.h"

namespace upbead {

/// All readings of the caisson; `momentum` from momentum_rows, `uplift` from uplift_rows, `loads` from compile_loads.
std::vector<Reading> caisson_readings(const Caisson& caisson, const CaissonForces& forces,
                                      const std::array<Row, n_motions>& momentum,
                                      const std::array<Row, n_motions>& uplift, const SceneLoads& loads, bool inertia);

/// Work of the excess pore pressure on the caisson's contact with porous ground, in unit motions about the bottom's
/// centre, as rows over x': the uplift U (N/m, motion_y) and its moment (N m/m, motion_rotation). The uplift is a
/// part of the total normal force, not an additional outer load.
std::array<Row, n_motions> uplift_rows(const Space& space, const Unknowns& unknowns, const Caisson& caisson);

inline const std::string base_group = "base";

/// At every node of the bottom: normal_stress (change of the effective stress on the ground, compression positive),
/// shear_stress (on the ground, landward), pore_pressure (Pa) where there is pore water, and displacement_x,
/// displacement_y of the ground (m). A stress is the consistent nodal force over the node's length. The sums of
/// stress times length are exactly F_T, the normal force less the uplift, and the uplift (Hughes, Engel, Mazzei and
/// Larson, J. Comput. Phys. 163 (2000) 467: such fluxes are conserved, those of single elements are not). `bottom`
/// collects the forces of `nodes`; `loads` are those of the scene.
std::vector<Reading> base_readings(const Space& space, const Unknowns& unknowns,
                                   const std::vector<InterfaceNode>& nodes, const NodalReaction& bottom,
                                   const SceneLoads& loads);

}  // namespace upbead
