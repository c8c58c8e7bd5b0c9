// The modes of a dense matrix.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace upbead::detail {

/// A X = X diag(pole), of conjugate pairs both.
struct Modes {
  Eigen::VectorXcd pole;
  Eigen::MatrixXcd X;
  Eigen::MatrixXcd load;  ///< X^-1 B

  /// Those that make a real sum: one of each pair of conjugates.
  std::vector<int> kept() const;
  /// Rows R X of the kept modes, those of pairs doubled: R s = Re (row z).
  Eigen::MatrixXcd reading(const Eigen::MatrixXcd& rows_X, const std::vector<int>& modes) const;
};

/// Throws NumericsError where X diag(pole) X^-1 B misses A B by more than 1e-8.
Modes diagonalise(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace upbead::detail
