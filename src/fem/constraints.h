// Essential conditions: rigid regions, fixed and roller sides, levels of free water, contact of water with pores, and
// hanging nodes.
#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <string>
#include <vector>

#include "fem/caisson/bottom.h"
#include "fem/caisson/rigid_body.h"
#include "fem/space.h"

namespace upbead {

/// Additional unknowns that move boundaries, or their pore water, beside rigid bodies: plates shift along their
/// normals, loads prescribe motions of boundaries and pressures on open ones. One unknown each, from first_plate and
/// first_load on.
struct SceneMotions {
  std::vector<std::string> plates;  ///< curves
  std::vector<std::string> loads;   ///< names
  dealii::types::global_dof_index first_plate, first_load;
};
SceneMotions scene_motions(const Space& space, const Scene& scene, std::size_t n_bodies);

/// All constraints on the degrees of freedom of the space. Indices from n_dofs() on stand for the rigid bodies'
/// coordinates (three each), then for plates and loads of `motions`, then for the slips and the openings of an
/// interface: the degrees of freedom at an interface are those of the ground, which are the caisson's less slip and
/// opening.
dealii::AffineConstraints<double> make_constraints(const Space& space, const Scene& scene,
                                                   const std::vector<Body>& bodies, const SceneMotions& motions,
                                                   const std::vector<InterfaceNode>& interface = {});

/// u and phi of smaller cells follow the larger cell's shape functions on the common side. Both cells are of one
/// kind: surfaces meet without hanging nodes (see mesh/refine.h).
void add_hanging_nodes(dealii::AffineConstraints<double>& constraints, const Space& space);

}  // namespace upbead
