// The caisson in the system of equations: its motion, and the forces between the mound and its bottom.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "fem/caisson/rigid_body.h"
#include "fem/faces.h"
#include "fem/unknowns.h"
#include "upbead/base/still_water.h"

namespace upbead {

/// Position and inertia of the caisson.
struct Caisson {
  Body body;
  dealii::Point<dim> bottom_centre;  ///< middle of the contact with the ground (m)
  double bottom_width = 0.;          ///< horizontal extent of that contact, B (m)
};

/// None where the mesh has no surface of the caisson's name, or where that surface touches nothing and has no springs.
std::optional<Caisson> find_caisson(const Space& space);

/// What still water at the two levels of [initial] does to the caisson, beside its weight in water as high as the sea;
/// nothing where it has one level.
StillWater still_water(const Scene& scene, const Caisson& caisson);

/// Rows of linear momentum (x, y) and angular momentum about the centre of gravity (clockwise): p_m . v.
std::array<Row, n_motions> momentum_rows(const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
                                         const Body& caisson, double density);

/// The caisson's unit motions (about the centre of its bottom) as vectors of unknowns: the caisson's nodes move, all
/// others stay. The equations tested with a unit motion are the balance of forces on the caisson; the caisson's own
/// stiffness adds nothing, as rigid motions do not strain it.
std::vector<Vector> caisson_motions(const Space& space, const Unknowns& unknowns, const Caisson& caisson);

/// Sums of nodal forces: for each degree of freedom, the sums to which it contributes, and its weight in each.
struct NodalSums {
  int n = 0;
  std::vector<std::vector<std::pair<int, double>>> of_dof;
};

/// The work of nodal forces in each unit motion of the caisson (about the centre of its bottom).
NodalSums sums_of_motions(const Space& space, const Caisson& caisson);
/// The forces landward (2 i) and upward (2 i + 1) at every node i of the bottom.
NodalSums sums_of_nodes(const Space& space, const std::vector<InterfaceNode>& nodes);

/// Collects, cell by cell and face by face, the rows of the caisson's surroundings at its nodes: sums of the
/// consistent nodal forces that move these nodes with the caisson, as rows over x, x', x''.
class NodalReaction {
 public:
  NodalReaction(const Unknowns& unknowns, NodalSums sums);

  /// Adds a cell or a face that does not belong to the caisson.
  void add(const CellMatrices& cell, const Dofs& dofs);
  /// Adds a spring and a dashpot to one of the sums: its force is stiffness times the motion, damping times its rate.
  void add(int sum, double stiffness, double damping, const Row& motion);
  /// Adds a mass that moves with the caisson, as a row over the accelerations.
  void add_mass(int sum, const Row& mass);
  /// Whether some of these degrees of freedom count in a sum, so that there is something to add.
  bool has_any(const Dofs& dofs) const;
  /// The value of one of the sums for given nodal forces.
  double sum(int sum, const NodalForces& forces) const;
  /// The weights of nodal forces in one of the sums, by degree of freedom.
  Row nodal_forces(int sum) const;
  Row position(int sum) const { return to_row(K_[sum]); }
  Row velocity(int sum) const { return to_row(C_[sum]); }
  Row acceleration(int sum) const { return to_row(M_[sum]); }

 private:
  const Unknowns* unknowns_;
  NodalSums sums_;
  std::vector<std::map<int, double>> M_, C_, K_;
};

/// The forces on the caisson, separately for each part of its surroundings.
struct CaissonForces {
  NodalReaction ground;                 ///< its x component is the shear force F_T by route (ii)
  NodalReaction water_front;            ///< water on its faces that look seaward; x: -P_water of the front
  NodalReaction water_back;             ///< water on all its other faces
  std::optional<NodalReaction> bottom;  ///< the ground's forces at each node, where asked for

  /// `bottom_nodes`: nodes of the bottom, where forces at each node are asked for.
  CaissonForces(const Space& space, const Unknowns& unknowns, const Caisson& caisson,
                const std::vector<InterfaceNode>& bottom_nodes = {});
  void add_ground(const CellMatrices& cell, const Dofs& dofs);
  /// Adds the face of a wet solid: water on the caisson, or, if the solid is another region, a part of the ground.
  void add(const WetFace& face, const Space& space, const FaceTerms& terms);
};

}  // namespace upbead
