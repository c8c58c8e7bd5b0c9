// Direct solution with one symmetric quasi-definite matrix: equilibrate, eliminate cell-local blocks, L D L^T.
#pragma once

#include <memory>
#include <vector>

#include "upbead/algebra/sparse.h"

namespace upbead {

/// Number of positive and negative pivots of L D L^T (Sylvester's law of inertia), local blocks included.
struct Inertia {
  int positive = 0;
  int negative = 0;
};

/// Factors of a symmetric quasi-definite matrix A (n x n, both triangles stored). L D L^T exists for every ordering
/// without pivoting (Vanderbei 1995), but only an equilibrated matrix is solved to round-off.
class Factorisation {
 public:
  /// `blocks`: disjoint ranges of unknowns that couple among themselves and with the rest, but not with other blocks;
  /// they are condensed by dense Cholesky before the sparse factorisation. Throws NumericsError where A is singular or
  /// not finite.
  explicit Factorisation(const SparseMatrix& A, const std::vector<IndexRange>& blocks = {});
  ~Factorisation();
  Factorisation(Factorisation&&) noexcept;

  /// x = A^-1 b.
  Vector solve(const Vector& b) const;
  Inertia inertia() const;
  /// Entries of the factor L that a solve streams through, without the blocks.
  long n_factor_entries() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace upbead
