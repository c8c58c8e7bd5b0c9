// Where the caisson stands on its ground: faces, and nodes that may slip and part.
#pragma once

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

#include "fem/faces.h"
#include "fem/kernels.h"
#include "fem/space.h"
#include "upbead/system/system.h"

namespace upbead {

/// Calls visit(cell of the ground, face) where it touches the caisson.
void for_each_bottom_face(const Space& space, const std::function<void(const Cell&, unsigned)>& visit);

/// Calls visit(index in the cell, component, node's point) for the displacements of a face.
void for_each_displacement(
    const Space& space, const Cell& cell, unsigned f,
    const std::function<void(unsigned index, unsigned component, const dealii::Point<dim>& at)>& visit);

class Unknowns;

/// A node of the rigid caisson's level bottom. Its degrees of freedom are the ground's: those of the caisson follow
/// from its coordinates alone.
struct InterfaceNode {
  dealii::types::global_dof_index ux = 0, uy = 0;
  double position = 0.;  ///< x (m)
  double length = 0.;    ///< integral of its shape function along the bottom: a force over it is a stress (m)
};

/// By ascending x; empty without a caisson. Nodes under a caisson that deforms are listed too, but cannot part from it.
std::vector<InterfaceNode> interface_nodes(const Space& space);

/// Whether the caisson's bottom is one level line.
bool bottom_is_level(const Mesh& mesh);

/// The mean slip of the bottom, and the openings of its ends; for an interface of `unknowns`.
std::vector<Reading> interface_readings(const Unknowns& unknowns, const std::vector<InterfaceNode>& nodes);

/// Calls visit(terms) for every face of porous ground under the caisson. Water fills what opens there, drawn from the
/// pores, and presses on both sides: with the nodes' openings o_i = shape_i o
///   op_C  -o phi  and its transpose,
/// so that what remains on a row of opening is the effective force.
void for_each_gap_term(const Space& space, const Unknowns& unknowns, const std::vector<InterfaceNode>& nodes,
                       const std::function<void(const FaceTerms&)>& visit);

}  // namespace upbead
