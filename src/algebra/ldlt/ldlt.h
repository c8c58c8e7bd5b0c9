// P A P^T = L D L^T of one sparse symmetric matrix.
#pragma once

#include "algebra/factorisation.h"
#include "multifrontal.h"

namespace upbead::detail {

/// L D L^T without pivoting of a symmetric quasi-definite matrix (both triangles stored, the lower one read, columns
/// ascending), by supernodes.
class Ldlt {
 public:
  /// Orders the unknowns and finds the pattern of L. With `sharing` A is the sum of what each process has of it, and so
  /// is B of a solve; X is known to all that hold an unknown. Each eliminates the unknowns that it alone holds, and all
  /// do the same to the sum of what is left in the shared ones (substructuring: Przemieniecki, AIAA J. 1 (1963) 138).
  /// Throws NumericsError where CHOLMOD fails.
  explicit Ldlt(const SparseMatrix& A, Sharing sharing = {});

  /// Factorises S A S, S = diag(scale), the diagonal of which should be +-1; A has the pattern of the constructor's.
  /// Throws NumericsError on a pivot that is not finite, or, where unknowns are shared, zero: elsewhere another one
  /// stands for it, negative where the diagonal was not positive.
  void factorise(const SparseMatrix& A, const Vector& scale);
  /// Each column of X = A^-1 times that of B; B and X (n x columns) may be the same.
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::Ref<Eigen::MatrixXd> X) const;
  /// The halves of a solve, where no unknown is shared: halfway() is then D^-1 L^-1 P S B, in elimination order and
  /// open to change, and X = S P^T L^-T halfway().
  void begin(const Eigen::Ref<const Eigen::MatrixXd>& B) const;
  Eigen::Map<Eigen::MatrixXd> halfway(Eigen::Index n_columns) const;
  void finish(Eigen::Ref<Eigen::MatrixXd> X) const;
  /// 1 / D, in elimination order.
  const Vector& inverse_pivot() const { return factor_.inverse_pivot; }
  Inertia inertia() const;
  /// The largest magnitude of a pivot. As the diagonal was +-1, a value g >> 1 tells that a pivot of the other sign
  /// close to zero came first, and that up to g units of round-off are lost.
  double growth() const;
  /// Pivots that others stand for: solutions then must be refined.
  int n_stand_ins() const { return factor_.n_stand_ins; }
  long n_factor_entries() const { return static_cast<long>(factor_.n_entries); }

 private:
  bool is_shared() const { return !sharing_.unknowns.empty(); }
  void load(const Eigen::Ref<const Eigen::MatrixXd>& B) const;
  void unload(Eigen::Ref<Eigen::MatrixXd> X) const;
  void sum_root(double* root, int n_columns) const;
  /// Of the diagonal, in elimination order; that of a row without one is negative: its unknown is a multiplier.
  std::vector<int> signs_of(const SparseMatrix& A) const;

  Sharing sharing_;
  Supernodes nodes_;
  PanelEntries entries_;
  Factor factor_;
  Vector scale_;  ///< in elimination order
  std::size_t work_size_;
  mutable BigArray x_, work_;  ///< of a solve of `n_columns_`
  mutable Eigen::Index n_columns_ = 0;
  mutable const double* end_ = nullptr;  ///< where the second half of a solve begins
  mutable std::vector<double> root_;     ///< right-hand sides of the shared unknowns, to be summed
};

}  // namespace upbead::detail
