// The contact of the caisson with its ground: faces, and nodes that may slip and open.
#pragma once

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

#include "fem/faces.h"
#include "fem/kernels.h"
#include "fem/space.h"
#include "upbead/system/system.h"

namespace upbead {

/// Calls visit(cell of the ground, face) for every face at which the ground touches the caisson.
void for_each_bottom_face(const Space& space, const std::function<void(const Cell&, unsigned)>& visit);

/// Calls visit(index in the cell, component, point of the node) for the displacements on a face.
void for_each_displacement(
    const Space& space, const Cell& cell, unsigned f,
    const std::function<void(unsigned index, unsigned component, const dealii::Point<dim>& at)>& visit);

class Unknowns;

/// A node of the rigid caisson's level bottom. Its degrees of freedom are those of the ground, of which springs have
/// none; the displacements of the caisson follow from the caisson's coordinates alone.
struct InterfaceNode {
  dealii::types::global_dof_index ux = 0, uy = 0;
  bool has_ground() const { return ux != dealii::numbers::invalid_dof_index; }
  double position = 0.;  ///< x (m)
  double length = 0.;    ///< integral of its shape function along the bottom: a force over it is a stress (m)
};

/// By ascending x; empty without a caisson. Nodes under a caisson that deforms are listed too, but cannot open.
std::vector<InterfaceNode> interface_nodes(const Space& space);

/// Whether the caisson's bottom is a single level line.
bool bottom_is_level(const Mesh& mesh);

/// The mean slip of the bottom, and the openings of its edges; for an interface of `unknowns`.
std::vector<Reading> interface_readings(const Unknowns& unknowns, const std::vector<InterfaceNode>& nodes);

/// Calls visit(terms) for every face of porous ground under the caisson. Water from the pores fills the gap where the
/// bottom opens, and presses on both sides of it: with the nodes' openings o_i = shape_i o
///   op_C  -o phi  and its transpose,
/// so that the row of an opening gives the effective force.
void for_each_gap_term(const Space& space, const Unknowns& unknowns, const std::vector<InterfaceNode>& nodes,
                       const std::function<void(const FaceTerms&)>& visit);

}  // namespace upbead
