// Direct solution with one symmetric quasi-definite matrix: eliminate cell-local blocks, equilibrate, L D L^T.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "upbead/algebra/processes.h"
#include "upbead/algebra/sparse.h"

namespace upbead {

/// Number of positive and negative pivots of L D L^T (Sylvester's law of inertia), including those of the local
/// blocks.
struct Inertia {
  int positive = 0;
  int negative = 0;
};

/// A few columns C beside a matrix A, and what the two halves of a solve with A need to know about C.
struct Border {
  SparseMatrix columns;    ///< C
  std::vector<int> rows;   ///< rows that the first half of a solve for C fills, in elimination order
  SparseMatrix halfway;    ///< result of the first half in these rows, for each column of C
  Vector pivot;            ///< D in these rows
  SparseMatrix in_blocks;  ///< A_bb^-1 C_b, transposed
  Eigen::MatrixXd gram;    ///< C^T A^-1 C
};

/// Factors of a symmetric quasi-definite matrix A (n x n, both triangles stored). L D L^T exists for every ordering
/// without pivoting (Vanderbei 1995), but only an equilibrated matrix is solved to round-off.
/// Where negative pivots close to zero come first (incompressible water that hardly drains), elimination loses
/// digits; each solution is then refined with residuals of A, which recovers the digits.
/// Only one thread may use an object at a time.
class Factorisation {
 public:
  /// `blocks`: disjoint ranges of unknowns. The unknowns of a block couple among themselves and with the rest, but
  /// not with other blocks, and A is positive definite on each block. Blocks are condensed by dense Cholesky before
  /// the sparse factorisation. Throws NumericsError where A is singular or not finite, std::invalid_argument where
  /// blocks overlap or couple.
  ///
  /// With `sharing` the matrix is the sum of the A of all processes, each over the unknowns that it holds; so are
  /// right-hand sides. All processes make the same calls, and each gets the solution in its unknowns. No block holds
  /// a shared unknown. Where the matrix is singular, all throw.
  explicit Factorisation(const SparseMatrix& A, const std::vector<IndexRange>& blocks = {},
                         const Sharing& sharing = {});
  /// The same in less memory: A is emptied before the factor is computed; `again` gives it anew, in these calls alone,
  /// where solutions are to be refined.
  using Again = std::function<SparseMatrix()>;
  Factorisation(SparseMatrix&& A, const std::vector<IndexRange>& blocks, const Sharing& sharing, const Again& again);
  ~Factorisation();
  Factorisation(Factorisation&&) noexcept;
  Factorisation& operator=(Factorisation&&) noexcept;

  /// Factorises other values on the same pattern and blocks, without ordering and symbolic phase. Throws NumericsError
  /// as the constructor does, std::invalid_argument where the pattern differs.
  void refactor(const SparseMatrix& A);
  void refactor(SparseMatrix&& A, const Again& again);
  /// x = A^-1 b.
  Vector solve(const Vector& b) const;
  /// x = A^-1 b without allocation; x has the size of b and is not b.
  void solve(const Eigen::Ref<const Vector>& b, Eigen::Ref<Vector> x) const;
  /// X = A^-1 B. Up to 8 right-hand sides are solved in one pass through the factor; results are the same as one by
  /// one (up to round-off where unknowns are shared).
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& B) const;
  /// A solve in two halves: the first gives C^T A^-1 b, before it is decided how much of the columns C acts. Only
  /// where solutions are not refined and no unknown is shared.
  bool has_halves() const;
  Border border(const SparseMatrix& columns) const;
  /// The first half; returns C^T A^-1 b.
  Vector begin(const Eigen::Ref<const Vector>& b, const Border& border) const;
  /// The second half: x = A^-1 (b - C q), with the b of begin(); b becomes b - C q.
  void finish(Eigen::Ref<Vector> b, const Border& border, const Vector& q, Eigen::Ref<Vector> x) const;
  /// Inertia of the whole matrix, the sum over processes.
  Inertia inertia() const;
  /// Stored entries of the factor L, including padding; a solve reads them twice. Without the blocks, and without the
  /// shared unknowns.
  long n_factor_entries() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace upbead
