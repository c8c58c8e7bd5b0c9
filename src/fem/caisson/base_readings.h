// Stress, pore pressure and displacement along the caisson's bottom.
#pragma once

#include <string>
#include <vector>

#include "fem/caisson/caisson.h"
#include "fem/scene_loads.h"

namespace upbead {

inline const std::string base_group = "base";

/// At every node of the bottom: normal_stress (change of the effective stress on the ground, compression positive),
/// shear_stress (on the ground, landward), where there is pore water pore_pressure (Pa), and displacement_x,
/// displacement_y of the ground (m). The stresses are the consistent nodal forces
/// over the lengths of the nodes: times these they sum to F_T, to the normal force less the uplift, and to the uplift,
/// exactly (Hughes, Engel, Mazzei and Larson, J. Comput. Phys. 163 (2000) 467: such fluxes are conserved, those of
/// single elements are not). `bottom` collects the forces of `nodes`, `loads` are those of the scene.
std::vector<Reading> base_readings(const Space& space, const Unknowns& unknowns,
                                   const std::vector<InterfaceNode>& nodes, const NodalReaction& bottom,
                                   const SceneLoads& loads);

}  // namespace upbead
