// A basis that serves many Systems with the same unknowns.
#pragma once

#include <vector>

#include "dynamics/snapshots.h"
#include "upbead/dynamics/krylov.h"

namespace upbead {

/// Orthonormal directions of both kinds, from the snapshots of several systems (proper orthogonal decomposition, one
/// kind apart from the other, so that a projection keeps the signs of M, C and K). Coordinates: first the prescribed
/// unknowns and those that are kept exactly, then the directions of each set of snapshots as they came.
class SnapshotBasis {
 public:
  /// `like`: a system whose T(shift) gives the units; `exact`: unknowns that are coordinates themselves.
  SnapshotBasis(const System& like, double shift, const std::vector<int>& exact);
  /// Adds directions until what is left of the snapshots is less than `rest` of them, in the norm of each kind.
  void add(const Snapshots& of, double rest);

  const FieldBasis& displacements() const { return u_; }
  const FieldBasis& phi() const { return phi_; }
  int n_coordinates() const { return n_coordinates_; }
  /// Number of the coordinates that are kept exactly.
  int n_kept() const { return n_kept_; }
  /// To coordinates in which directions of each kind are sorted by what they hold of all snapshots, the most first; the
  /// exact ones stay. Its columns are the new coordinates: the kept ones, then both kinds in turns.
  Eigen::MatrixXd sorting() const;
  /// The basis of phi in coordinates that are turned by such a matrix.
  FieldBasis phi_in(const Eigen::MatrixXd& rotation) const;

 private:
  void add(FieldBasis& basis, Eigen::MatrixXd& held, const Eigen::MatrixXd& of, double rest);

  FieldBasis u_, phi_;
  Eigen::MatrixXd held_u_, held_phi_;  ///< coordinates of all snapshots, by direction that is not kept
  int n_coordinates_ = 0, n_kept_ = 0;
};

}  // namespace upbead
