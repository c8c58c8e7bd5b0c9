// Essential conditions: rigid regions, fixed and roller sides, levels of free water and where it meets pores, hanging
// nodes.
#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <string>
#include <vector>

#include "fem/caisson/bottom.h"
#include "fem/caisson/rigid_body.h"
#include "fem/space.h"

namespace upbead {

/// Loads of kind pressure on open boundaries, which prescribe the pore pressure there.
std::vector<std::string> pressure_prescribing_loads(const Space& space, const Scene& scene);

/// All constraints on the degrees of freedom of the space. Indices from n_dofs() on stand for the rigid bodies'
/// coordinates (three each), then for the unknowns of pressure_prescribing_loads, then for the slips and the openings
/// of an interface: its degrees of freedom are those of the ground, caisson less slip and opening.
dealii::AffineConstraints<double> make_constraints(const Space& space, const Scene& scene,
                                                   const std::vector<Body>& bodies,
                                                   const std::vector<InterfaceNode>& interface = {});

/// u and phi of the smaller cells follow the larger cell's shape functions on their common side. Both are of one kind:
/// surfaces meet without hanging nodes (see mesh/refine.h).
void add_hanging_nodes(dealii::AffineConstraints<double>& constraints, const Space& space);

}  // namespace upbead
