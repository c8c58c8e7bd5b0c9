// Dense matrices of a ground of few coordinates with an interface.
#pragma once

#include <Eigen/Core>

#include "dynamics/carried_motions.h"

namespace upbead {

/// Products of C and K with a vector.
struct GroundProducts {
  Vector C, K;
};

/// M, C and K of r free coordinates (f), in which K_ff is diagonal, and of m motions of an interface (i). Smooth
/// motions of the interface alone couple with the free ones: the blocks fi are A U^T with U' U = 1 and few columns.
struct GroundMatrices {
  Eigen::MatrixXd M_ff, C_ff, M_ii, C_ii, K_ii;
  Vector K_ff;
  Eigen::MatrixXd U;              ///< m x k
  Eigen::MatrixXd M_f, C_f, K_f;  ///< A of each: r x k
  Eigen::MatrixXd of_free;        ///< C_ff, M_f', C_f', K_f' one below the other
  Eigen::MatrixXd of_along;       ///< C_f, K_f, likewise
  Eigen::MatrixXd of_interface;   ///< C_ii, K_ii, likewise

  /// The blocks of the free coordinates, with K diagonal, those of free ones with the interface, and of the interface;
  /// couplings below 1e-11 of the largest about the shift are left out.
  GroundMatrices(OfMatrices free, const OfMatrices& coupling, const OfMatrices& interface, double shift);

  Eigen::Index n_free() const { return K_ff.size(); }
  GroundProducts products(const Vector& a) const;
  /// M v.
  Vector with_mass(const Vector& v) const;
};

/// A x, of which only ranges of each half of x are not zero.
Vector product_of_some(const Eigen::MatrixXd& A, const Eigen::Ref<const Vector>& x);

}  // namespace upbead
