// P A P^T = L D L^T of one sparse symmetric matrix.
#pragma once

#include "multifrontal.h"
#include "upbead/algebra/factorisation.h"

namespace upbead::detail {

/// L D L^T without pivoting of a symmetric quasi-definite matrix (both triangles stored, the lower one read, columns
/// ascending), by supernodes.
class Ldlt {
 public:
  /// Orders the unknowns and finds the pattern of L. Throws NumericsError where that fails.
  explicit Ldlt(const SparseMatrix& A);

  /// Factorises S A S, S = diag(scale), the diagonal of which should be +-1; A has the pattern of the constructor's.
  /// Throws NumericsError on a pivot that is zero or not finite.
  void factorise(const SparseMatrix& A, const Vector& scale);
  /// Each column of X = A^-1 times that of B; B and X (n x columns) may be the same.
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::Ref<Eigen::MatrixXd> X) const;
  Inertia inertia() const;
  long n_factor_entries() const { return static_cast<long>(factor_.n_entries); }

 private:
  Supernodes nodes_;
  PanelEntries entries_;
  Factor factor_;
  Vector scale_;  ///< in elimination order
  std::size_t work_size_;
  mutable BigArray x_, work_;  ///< of a solve of `n_columns_`
  mutable Eigen::Index n_columns_ = 0;
};

}  // namespace upbead::detail
