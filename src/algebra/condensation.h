// Elimination of cell-local blocks from a symmetric matrix: its Schur complement in the remaining unknowns.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "big_array.h"
#include "upbead/algebra/sparse.h"

namespace upbead::detail {

/// With unknowns split into blocks (b) and the rest (r): S = A_rr - A_rb A_bb^-1 A_br, block by block. What a solve
/// needs from a block, the inverse A_bb^-1 and the weights W = A_bb^-1 A_br, lies in one array, in the order of use.
/// A positive definite block needs no equilibration: Cholesky's error does not depend on diagonal scaling.
class Condensation {
 public:
  /// Finds the patterns. Throws std::invalid_argument where blocks overlap or couple.
  Condensation(const SparseMatrix& A, const std::vector<IndexRange>& blocks);

  /// Condenses the values of A (same pattern) into `schur`. Throws NumericsError where a block is not positive
  /// definite.
  void condense(const SparseMatrix& A);
  /// S; both triangles and the whole diagonal are stored, columns ascend.
  const SparseMatrix& schur() const { return schur_; }
  SparseMatrix& schur() { return schur_; }

  /// rest = b_r - W^T b_b.
  void reduce(const Eigen::Ref<const Vector>& b, Eigen::Ref<Vector> rest) const;
  /// x_r = rest, x_b = A_bb^-1 b_b - W x_r.
  void expand(const Eigen::Ref<const Vector>& b, const Eigen::Ref<const Vector>& rest, Eigen::Ref<Vector> x) const;
  int n_rest() const { return static_cast<int>(schur_.rows()); }
  /// Row of an unknown in S; -1 where it is in a block.
  int rest_index(int unknown) const { return rest_index_[unknown]; }
  /// Unknowns in blocks.
  int n_local() const { return static_cast<int>(block_of_.size()) - n_rest(); }

 private:
  struct Block {
    IndexRange range;
    int rest_begin = 0, rest_end = 0;  ///< the rest unknowns that the block couples to, in `block_rest_`
    std::size_t values = 0;            ///< where the block's inverse and weights begin, in `values_`
    int n_rest() const { return rest_end - rest_begin; }
  };
  using DenseMap = Eigen::Map<Eigen::MatrixXd>;

  void find_couplings(const SparseMatrix& A);
  void find_pattern(const SparseMatrix& A);
  void factorise(const SparseMatrix& A, const Block& block);
  void find_weights();
  /// First the lower triangle L of A_bb = L L^T, then A_bb^-1.
  DenseMap own(const Block& block) const {
    return {values_.get() + block.values, block.range.size(), block.range.size()};
  }
  /// First Y = L^-1 A_br, then W; one column per rest unknown.
  DenseMap coupled(const Block& block) const {
    const std::ptrdiff_t n = block.range.size();
    return {values_.get() + block.values + n * n, n, block.n_rest()};
  }

  std::vector<Block> blocks_;
  std::vector<int> block_rest_;
  BigArray values_;
  std::vector<int> block_of_;                               ///< per unknown: its block, or -1
  std::vector<int> rest_index_;                             ///< per unknown: its row in S, or -1
  std::vector<int> rest_unknown_;                           ///< per row of S: its unknown
  std::vector<std::vector<std::pair<int, int>>> touching_;  ///< per row of S: (block, column in that block)
  SparseMatrix schur_;
};

}  // namespace upbead::detail
