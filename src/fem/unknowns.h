// From degrees of freedom to unknowns: every degree of freedom is a weighted sum of unknowns.
#pragma once

#include <deal.II/lac/affine_constraints.h>

#include <map>
#include <utility>
#include <vector>

#include "fem/caisson/bottom.h"
#include "fem/caisson/rigid_body.h"
#include "fem/space.h"
#include "upbead/system/system.h"

namespace upbead {

/// Nodal forces on some cells: degree of freedom -> force (N/m).
using NodalForces = std::map<unsigned, double>;

/// Degree of freedom i of the space is sum_j weight_j x_j over its expansion; fixed ones have an empty expansion.
/// Order of the unknowns x: free u and phi, three coordinates per rigid body, one per plate, W cell by cell,
/// prescribed motions and pressures, and, where an interface is given, slips and openings of its nodes.
class Unknowns {
 public:
  Unknowns(const Space& space, const Scene& scene, const std::vector<Body>& bodies,
           const std::vector<InterfaceNode>& interface = {});

  int size() const { return static_cast<int>(field_.size()); }
  int n_free() const { return size() - n_prescribed(); }
  const Row& expansion(dealii::types::global_dof_index dof) const { return expansion_[dof]; }
  /// Expansion for the caisson's own node, where it may open from the ground's.
  const Row& caisson_expansion(dealii::types::global_dof_index dof) const;
  const std::vector<Field>& field() const { return field_; }
  const std::vector<IndexRange>& blocks() const { return blocks_; }
  int n_prescribed() const { return static_cast<int>(prescribed_.size()) + 2 * n_interface_; }
  /// Index of the opening of a node of the interface.
  int opening(int node) const { return size() - n_interface_ + node; }
  /// Index of a rigid body's coordinate.
  int coordinate(std::size_t body, int motion) const {
    return first_coordinate_ + n_motions * static_cast<int>(body) + motion;
  }
  /// Index of the unknown whose velocity is the history of a load that prescribes a pore pressure or a motion; -1 for
  /// other loads.
  int prescribed(const std::string& load) const;
  /// Values at all degrees of freedom of the space, from values of the unknowns.
  Vector expand(const Vector& x) const;
  /// The same, but at the nodes of an interface with the displacements of the caisson instead of the ground's.
  Vector expand_caisson(const Vector& x) const;
  bool has_interface() const { return n_interface_ > 0; }
  /// Number of slips and openings.
  int n_interface() const { return 2 * n_interface_; }
  /// Adds weight * (value of a degree of freedom) to a row over the unknowns, given as a map.
  void add_to(std::map<int, double>& row, dealii::types::global_dof_index dof, double weight) const;

 private:
  void number(const Space& space, const dealii::AffineConstraints<double>& constraints, std::size_t n_coordinates,
              const std::vector<Field>& prescribed);
  void separate(const std::vector<InterfaceNode>& interface);

  std::vector<Row> expansion_;
  std::vector<Field> field_;
  std::vector<IndexRange> blocks_;
  std::vector<std::string> prescribed_;                        ///< names of the loads that prescribe
  std::map<dealii::types::global_dof_index, Row> of_caisson_;  ///< by degree of freedom of the interface
  int n_interface_ = 0;                                        ///< nodes
  int first_coordinate_ = 0;
};

/// A row from the map that add_to has filled; zero weights are dropped.
Row to_row(const std::map<int, double>& entries);
Row scaled(Row row, double factor);

}  // namespace upbead
