// Elimination of cell-local blocks from a symmetric matrix: its Schur complement in the remaining unknowns.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "upbead/algebra/sparse.h"

namespace upbead::detail {

/// With unknowns split into blocks (b) and the rest (r): S = A_rr - A_rb A_bb^-1 A_br, block by block with
/// A_bb = L L^T and Y = L^-1 A_br. A positive definite block needs no equilibration: Cholesky's error does not depend
/// on diagonal scaling.
class Condensation {
 public:
  /// Finds the patterns. Throws std::invalid_argument where blocks overlap or couple.
  Condensation(const SparseMatrix& A, const std::vector<IndexRange>& blocks);

  /// Condenses the values of A (same pattern) into `schur`. Throws NumericsError where a block is not positive
  /// definite.
  void condense(const SparseMatrix& A);
  /// S; both triangles and the whole diagonal are stored, columns ascend.
  SparseMatrix& schur() { return schur_; }
  const SparseMatrix& schur() const { return schur_; }

  /// From b: z = L^-1 b_b per block (kept in `local`), and b_r - Y^T z (into `rest`).
  void reduce(const Eigen::Ref<const Vector>& b, Vector& local, Vector& rest) const;
  /// x_r = rest, x_b = L^-T (z - Y x_r).
  void expand(const Vector& local, const Vector& rest, Eigen::Ref<Vector> x) const;
  int n_rest() const { return static_cast<int>(schur_.rows()); }

 private:
  struct Block {
    IndexRange range;
    std::vector<int> rest;    ///< rest unknowns that it couples to
    Eigen::MatrixXd lower;    ///< L
    Eigen::MatrixXd coupled;  ///< Y, one column per entry of `rest`
  };

  void find_couplings(const SparseMatrix& A);
  void find_pattern(const SparseMatrix& A);
  void factorise(const SparseMatrix& A, Block& block) const;

  std::vector<Block> blocks_;
  std::vector<int> block_of_;                               ///< per unknown: its block, or -1
  std::vector<int> rest_index_;                             ///< per unknown: its row in S, or -1
  std::vector<int> rest_unknown_;                           ///< per row of S: its unknown
  std::vector<std::vector<std::pair<int, int>>> touching_;  ///< per row of S: (block, column of Y)
  SparseMatrix schur_;
};

}  // namespace upbead::detail
