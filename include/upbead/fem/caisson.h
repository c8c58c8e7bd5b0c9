// The caisson in the system of equations: its motion, and the forces that the mound exchanges with its bottom.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "upbead/fem/faces.h"
#include "upbead/fem/rigid_body.h"
#include "upbead/fem/unknowns.h"

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

/// Collects, cell by cell and face by face, what the matrices of the caisson's surroundings say about its nodes: the
/// consistent nodal force that moves them with the caisson, as rows over x, x', x''.
class NodalReaction {
 public:
  NodalReaction(const Space& space, const Unknowns& unknowns, const Caisson& caisson);

  /// Adds a cell or a face that does not belong to the caisson.
  void add(const CellMatrices& cell, const std::vector<dealii::types::global_dof_index>& dofs);
  /// Whether some of these degrees of freedom move with the caisson, so that there is something to add.
  bool has_any(const std::vector<dealii::types::global_dof_index>& dofs) const;
  /// Work of nodal forces on the caisson's nodes in a unit motion (about the bottom's centre).
  double work(int motion, unsigned dof, double force) const { return motions_[dof][motion] * force; }
  Row position(int motion) const { return to_row(K_[motion]); }
  Row velocity(int motion) const { return to_row(C_[motion]); }
  Row acceleration(int motion) const { return to_row(M_[motion]); }

 private:
  const Unknowns* unknowns_;
  std::vector<std::array<double, n_motions>> motions_;  ///< of every degree of freedom; zero off the caisson
  std::array<std::map<int, double>, n_motions> M_, C_, K_;
};

/// The surroundings of the caisson, apart.
struct CaissonForces {
  NodalReaction ground;       ///< its x part is the shear force F_T by route (ii)
  NodalReaction water_front;  ///< water on its faces that look seaward; its x part is -P_water of the front
  NodalReaction water_back;   ///< water on all its other faces

  CaissonForces(const Space& space, const Unknowns& unknowns, const Caisson& caisson)
      : ground(space, unknowns, caisson), water_front(ground), water_back(ground) {}
  /// Which of them a wet face belongs to; one of another solid is the ground's.
  NodalReaction& of(const WetFace& face, const Space& space);
};

}  // namespace upbead
