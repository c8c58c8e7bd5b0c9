// Galerkin projection of a System on a Krylov space, displacements and phi apart.
#pragma once

#include <memory>
#include <vector>

#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/reduced_system.h"

namespace upbead {

/// Projects on all coordinates of a space, and on new ones as the space grows. u and W share one basis and phi has
/// another, so the signs of the System's matrices are kept; a rigid caisson's motions are coordinates, so the balance
/// of its forces holds to round-off. In a divided system it is a sum over processes, the same on each.
class Projection {
 public:
  /// The space must outlive the object; the System is read here alone. Throws std::logic_error where M or K couples phi
  /// with u or W.
  Projection(const System& system, const SecondOrderKrylov& krylov);
  /// Projects on bases of any space, whose coordinates are numbered across both; `shift`: ReducedSystem::shift.
  Projection(const System& system, const FieldBasis& displacements, const FieldBasis& phi, double shift);
  /// The same System as `of` projects, on bases whose directions so far are the first ones of the bases of `of`:
  /// `reduced` is what it is in these.
  Projection(const Projection& of, ReducedSystem reduced, const FieldBasis& displacements, const FieldBasis& phi);
  /// Adds the coordinates that have come to the space since.
  void extend();
  const ReducedSystem& reduced() const { return reduced_; }

 private:
  /// The diagonal blocks of the matrices that belong to one basis, in its units.
  struct Blocks {
    std::vector<int> rows;  ///< of the basis, on which the matrices are not zero
    SparseMatrix M, C, K;   ///< on these rows
  };
  struct Matrices {
    Blocks u, phi;
    SparseMatrix C_phiu;                            ///< rows of phi, columns of u and W
    SparseMatrix position, velocity, acceleration;  ///< readings x unknowns
    std::vector<Vector> loads;                      ///< by unknown; empty of a load that is zero
  };
  struct Group {
    const FieldBasis& basis;
    const Blocks& blocks;
    Eigen::Index n_projected;  ///< columns of the basis
  };

  static Blocks blocks_of(const System& system, const FieldBasis& basis);
  static Matrices matrices_of(const System& system, const FieldBasis& displacements, const FieldBasis& phi);
  /// The basis on the rows of the group.
  static Eigen::MatrixXd columns_of(const Group& group);
  void resize();
  void project(Group& group);
  void project_coupling();
  void project_rows(const Group& group);
  void project_loads(const Group& group);

  std::shared_ptr<const Matrices> matrices_;
  Group u_, phi_;
  ReducedSystem reduced_;
};

}  // namespace upbead
