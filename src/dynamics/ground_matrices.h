// Dense matrices of a ground of few coordinates with an interface.
#pragma once

#include <Eigen/Core>

#include "dynamics/carried_motions.h"

namespace upbead {

/// Products of M, C and K with a vector [f; i; U' i]. Rows are those of the free coordinates, of the interface but for
/// what is along U, and of that along U: the rows of the interface are the second ones and U times the last ones. So
/// their products with such a vector are those of the whole.
struct GroundProducts {
  Vector M, C, K;
};

/// M, C and K of r free coordinates (f), in which K_ff is diagonal, and of m motions of an interface (i). M_ff is
/// diagonal, too, in the first ones, and couples these with no others. The blocks fi are A U^T with U' U = 1 and few
/// columns.
struct GroundMatrices {
  Eigen::MatrixXd M_ff, C_ff, M_ii, C_ii, K_ii;
  Vector K_ff;
  Eigen::MatrixXd U;              ///< m x k
  Eigen::MatrixXd M_f, C_f, K_f;  ///< A of each: r x k

  /// The blocks of the free coordinates, of which M is diagonal in the first `n_diagonal`, those of free ones with the
  /// interface, and of the interface. Of the couplings the part along `exactly` (m x any) is kept, and of the rest what
  /// counts about the shift.
  GroundMatrices(OfMatrices free, const OfMatrices& coupling, const OfMatrices& interface,
                 const Eigen::MatrixXd& exactly, Eigen::Index n_diagonal, double shift);

  Eigen::Index n_free() const { return K_ff.size(); }
  /// [f; i; U' i] of a vector [f; i].
  Vector with_along(const Vector& v) const;
  GroundProducts products(const Vector& v) const;
  /// The same of an a with (M + g C + g^2 K) a = rhs, in half of the work.
  GroundProducts products(const Vector& a, const Vector& rhs, double g) const;

 private:
  Vector M_diagonal_;           ///< zero where M_ff is not diagonal
  Eigen::MatrixXd M_rest_;      ///< the block of these coordinates, the last ones; empty where it is zero
  Eigen::MatrixXd from_along_;  ///< M_f, K_f one below the other
  Eigen::MatrixXd to_along_;    ///< C_f, K_f side by side
  Eigen::MatrixXd interface_;   ///< C_ii, K_ii one below the other
};

/// A x, of which only ranges of each half of x are not zero.
Vector product_of_some(const Eigen::MatrixXd& A, const Eigen::Ref<const Vector>& x);

}  // namespace upbead
