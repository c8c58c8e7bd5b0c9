// P A P^T = L D L^T of one sparse symmetric matrix.
#pragma once

#include "algebra/factorisation.h"
#include "algebra/shared_matrix.h"
#include "multifrontal.h"

namespace upbead::detail {

/// L D L^T without pivoting of a symmetric quasi-definite matrix (both triangles stored, the lower one read, columns
/// ascending), by supernodes.
class Ldlt {
 public:
  /// Orders the unknowns and finds the pattern of L. With `sharing`, A is the sum of the parts that the processes
  /// hold, as is B of a solve; each process gets X in its unknowns. Each eliminates the unknowns that it alone holds;
  /// what is left in the shared ones is summed and factorised by all together (substructuring: Przemieniecki,
  /// AIAA J. 1 (1963) 138). Throws NumericsError where CHOLMOD fails.
  explicit Ldlt(const SparseMatrix& A, const Sharing& sharing = {});

  /// Factorises S A S, S = diag(scale), the diagonal of which should be +-1; A has the pattern of the constructor's,
  /// and becomes S A S.
  /// Throws NumericsError on a pivot that is not finite, and, where unknowns are shared, on a zero pivot; then on all
  /// processes. Otherwise a zero pivot is replaced, by a negative one where the diagonal was not positive.
  void factorise(SparseMatrix& A, const Vector& scale);
  /// X = A^-1 B; B and X (n x columns) may be the same matrix.
  void solve(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::Ref<Eigen::MatrixXd> X) const;
  /// The halves of a solve, where no unknown is shared: after begin(), halfway() is D^-1 L^-1 P S B, in elimination
  /// order, and may be changed; finish() gives X = S P^T L^-T halfway().
  void begin(const Eigen::Ref<const Eigen::MatrixXd>& B) const;
  Eigen::Map<Eigen::MatrixXd> halfway(Eigen::Index n_columns) const;
  void finish(Eigen::Ref<Eigen::MatrixXd> X) const;
  /// 1 / D, in elimination order.
  const Vector& inverse_pivot() const { return factor_.inverse_pivot; }
  /// Of the unknowns that this process eliminates.
  Inertia inertia() const;
  /// Of those that all processes have factorised together.
  Inertia shared_inertia() const;
  /// The largest magnitude of a pivot. As the diagonal was +-1, a value g >> 1 shows that a pivot of the other sign
  /// close to zero came first, and that up to g units of round-off are lost. Of the unknowns that this process
  /// eliminates, as pivots of the others are chosen.
  double growth() const;
  /// Number of zero pivots that were replaced: if above 0, solutions must be refined.
  int n_stand_ins() const { return factor_.n_stand_ins; }
  long n_factor_entries() const { return static_cast<long>(factor_.n_entries); }

 private:
  void load(const Eigen::Ref<const Eigen::MatrixXd>& B) const;
  void unload(Eigen::Ref<Eigen::MatrixXd> X) const;
  void solve_root(int n_columns) const;
  /// Signs of the diagonal, in elimination order; negative where the diagonal is zero: that unknown is a multiplier.
  std::vector<int> signs_of(const SparseMatrix& A) const;

  Sharing sharing_;
  Supernodes nodes_;
  PanelEntries entries_;
  Factor factor_;
  std::unique_ptr<SharedMatrix> root_;  ///< null where no unknown is shared
  Vector scale_;                        ///< in elimination order
  std::size_t work_size_;
  mutable BigArray x_, work_;  ///< work space of a solve with `n_columns_` right-hand sides
  mutable Eigen::Index n_columns_ = 0;
  mutable const double* end_ = nullptr;  ///< end of the factor's entries, where the second half of a solve begins
};

}  // namespace upbead::detail
