// The caisson in the system of equations: its motion, and the forces that the mound exchanges with its bottom.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "fem/caisson/rigid_body.h"
#include "fem/faces.h"
#include "fem/unknowns.h"

namespace upbead {

/// Where the caisson stands and what it weighs.
struct Caisson {
  Body body;
  dealii::Point<dim> bottom_centre;  ///< middle of the contact with the ground (m)
  double bottom_width = 0.;          ///< horizontal extent of that contact, B (m)
};

/// None where the mesh has no surface of that name, or where it touches nothing.
std::optional<Caisson> find_caisson(const Space& space);

/// Rows of linear momentum (x, y) and angular momentum about the centre of gravity (clockwise): p_m . v.
std::array<Row, n_motions> momentum_rows(const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
                                         const Body& caisson, double density);

/// The caisson's unit motions (about its bottom's centre) over the unknowns: its own nodes move, all others stay. The
/// equations tested with one of them are the balance of forces on the caisson, to which its own stiffness, blind to
/// rigid motions, adds nothing.
std::vector<Vector> caisson_motions(const Space& space, const Unknowns& unknowns, const Caisson& caisson);

/// Sums of nodal forces: by degree of freedom, the sums it counts in and how much.
struct NodalSums {
  int n = 0;
  std::vector<std::vector<std::pair<int, double>>> of_dof;
};

/// The work in each unit motion of the caisson (about its bottom's centre).
NodalSums sums_of_motions(const Space& space, const Caisson& caisson);
/// The forces landward (2 i) and upward (2 i + 1) at every node i of its bottom.
NodalSums sums_of_nodes(const Space& space, const std::vector<InterfaceNode>& nodes);

/// Collects, cell by cell and face by face, what the matrices of the caisson's surroundings say about its nodes: sums
/// of the consistent nodal forces that move them with the caisson, as rows over x, x', x''.
class NodalReaction {
 public:
  NodalReaction(const Unknowns& unknowns, NodalSums sums);

  /// Adds a cell or a face that does not belong to the caisson.
  void add(const CellMatrices& cell, const Dofs& dofs);
  /// Whether some of these degrees of freedom move with the caisson, so that there is something to add.
  bool has_any(const Dofs& dofs) const;
  /// What nodal forces on the caisson's nodes amount to in one of the sums.
  double sum(int sum, const NodalForces& forces) const;
  /// The forces at degrees of freedom that make up one of the sums.
  Row nodal_forces(int sum) const;
  Row position(int sum) const { return to_row(K_[sum]); }
  Row velocity(int sum) const { return to_row(C_[sum]); }
  Row acceleration(int sum) const { return to_row(M_[sum]); }

 private:
  const Unknowns* unknowns_;
  NodalSums sums_;
  std::vector<std::map<int, double>> M_, C_, K_;
};

/// The surroundings of the caisson, apart.
struct CaissonForces {
  NodalReaction ground;                 ///< its x part is the shear force F_T by route (ii)
  NodalReaction water_front;            ///< water on its faces that look seaward; its x part is -P_water of the front
  NodalReaction water_back;             ///< water on all its other faces
  std::optional<NodalReaction> bottom;  ///< of the ground too, node by node, where asked for

  /// `bottom_nodes`: of the bottom, where forces are asked for node by node.
  CaissonForces(const Space& space, const Unknowns& unknowns, const Caisson& caisson,
                const std::vector<InterfaceNode>& bottom_nodes = {});
  void add_ground(const CellMatrices& cell, const Dofs& dofs);
  /// Adds the face of a wet solid: water on the caisson, or, of another solid, a part of the ground.
  void add(const WetFace& face, const Space& space, const FaceTerms& terms);
};

}  // namespace upbead
