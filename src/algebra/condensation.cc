#include "condensation.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "upbead/base/error.h"

namespace upbead::detail {

Condensation::Condensation(const SparseMatrix& A, const std::vector<IndexRange>& blocks)
    : block_of_(static_cast<std::size_t>(A.rows()), -1), rest_index_(static_cast<std::size_t>(A.rows()), -1) {
  for (const IndexRange& range : blocks) {
    for (int i = range.begin; i < range.end; ++i) {
      if (i < 0 || i >= A.rows() || block_of_[i] >= 0)
        throw std::invalid_argument("blocks overlap or leave the matrix");
      block_of_[i] = static_cast<int>(blocks_.size());
    }
    blocks_.push_back({range});
  }
  for (int i = 0; i < A.rows(); ++i) {
    if (block_of_[i] >= 0) continue;
    rest_index_[i] = static_cast<int>(rest_unknown_.size());
    rest_unknown_.push_back(i);
  }
  find_couplings(A);
  find_pattern(A);
}

void Condensation::find_couplings(const SparseMatrix& A) {
  touching_.resize(rest_unknown_.size());
  std::size_t n_values = 0;
  std::vector<int> rest;
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    Block& block = blocks_[k];
    rest.clear();
    for (int i = block.range.begin; i < block.range.end; ++i)
      for (SparseMatrix::InnerIterator it(A, i); it; ++it) {
        const int j = static_cast<int>(it.col()), other = block_of_[j];
        if (other < 0)
          rest.push_back(rest_index_[j]);
        else if (other != static_cast<int>(k) && it.value() != 0.)
          throw std::invalid_argument("blocks " + std::to_string(k) + " and " + std::to_string(other) + " couple");
      }
    std::sort(rest.begin(), rest.end());
    rest.erase(std::unique(rest.begin(), rest.end()), rest.end());
    for (std::size_t c = 0; c < rest.size(); ++c)
      touching_[rest[c]].emplace_back(static_cast<int>(k), static_cast<int>(c));
    block.rest_begin = static_cast<int>(block_rest_.size());
    block_rest_.insert(block_rest_.end(), rest.begin(), rest.end());
    block.rest_end = static_cast<int>(block_rest_.size());
    block.values = n_values;
    n_values += static_cast<std::size_t>(block.range.size()) * (block.range.size() + rest.size());
  }
  values_ = make_big_array(n_values);
}

void Condensation::find_pattern(const SparseMatrix& A) {
  const int n = static_cast<int>(rest_unknown_.size());
  std::vector<int> outer{0}, inner, row, seen_in(static_cast<std::size_t>(n), -1);
  for (int r = 0; r < n; ++r) {
    row.clear();
    const auto add = [&](int column) {
      if (seen_in[column] == r) return;
      seen_in[column] = r;
      row.push_back(column);
    };
    add(r);
    for (SparseMatrix::InnerIterator it(A, rest_unknown_[r]); it; ++it)
      if (rest_index_[it.col()] >= 0) add(rest_index_[it.col()]);
    for (const auto& [k, c] : touching_[r])
      for (int q = blocks_[k].rest_begin; q < blocks_[k].rest_end; ++q) add(block_rest_[q]);
    std::sort(row.begin(), row.end());
    inner.insert(inner.end(), row.begin(), row.end());
    outer.push_back(static_cast<int>(inner.size()));
  }
  schur_.resize(n, n);
  schur_.resizeNonZeros(outer.back());
  std::copy(outer.begin(), outer.end(), schur_.outerIndexPtr());
  std::copy(inner.begin(), inner.end(), schur_.innerIndexPtr());
}

void Condensation::factorise(const SparseMatrix& A, const Block& block) {
  DenseMap L = own(block), Y = coupled(block);
  L.setZero();
  Y.setZero();
  const auto rest_begin = block_rest_.begin() + block.rest_begin, rest_end = block_rest_.begin() + block.rest_end;
  for (int i = 0; i < L.rows(); ++i)
    for (SparseMatrix::InnerIterator it(A, block.range.begin + i); it; ++it) {
      const int j = static_cast<int>(it.col());
      if (block_of_[j] < 0)
        Y(i, std::lower_bound(rest_begin, rest_end, rest_index_[j]) - rest_begin) = it.value();
      else if (block_of_[j] == block_of_[block.range.begin])
        L(i, j - block.range.begin) = it.value();
    }
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(L);  // in place
  if (llt.info() != Eigen::Success || !(L.diagonal().array() > 0.).all())
    throw NumericsError("the cell block of unknowns " + std::to_string(block.range.begin) + " to " +
                        std::to_string(block.range.end - 1) + " is not positive definite");
  L.triangularView<Eigen::Lower>().solveInPlace(Y);
}

/// A_bb^-1 = L^-T L^-1 and W = L^-T Y, in the places of L and Y.
void Condensation::find_weights() {
  for (const Block& block : blocks_) {
    DenseMap L = own(block), W = coupled(block);
    L.triangularView<Eigen::Lower>().transpose().solveInPlace(W);
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(L.rows(), L.rows());
    L.triangularView<Eigen::Lower>().solveInPlace(inverse);
    L = inverse.transpose() * inverse;
  }
}

void Condensation::condense(const SparseMatrix& A) {
  for (const Block& block : blocks_) factorise(A, block);
  const int n = n_rest();
  std::vector<int> place(static_cast<std::size_t>(n), 0);
  for (int r = 0; r < n; ++r) {
    const int begin = schur_.outerIndexPtr()[r], end = schur_.outerIndexPtr()[r + 1];
    for (int k = begin; k < end; ++k) {
      place[schur_.innerIndexPtr()[k]] = k;
      schur_.valuePtr()[k] = 0.;
    }
    for (SparseMatrix::InnerIterator it(A, rest_unknown_[r]); it; ++it)
      if (const int column = rest_index_[it.col()]; column >= 0) schur_.valuePtr()[place[column]] += it.value();
    for (const auto& [k, c] : touching_[r]) {
      const DenseMap Y = coupled(blocks_[k]);
      for (int d = 0; d < Y.cols(); ++d)
        schur_.valuePtr()[place[block_rest_[blocks_[k].rest_begin + d]]] -= Y.col(c).dot(Y.col(d));
    }
  }
  find_weights();
}

void Condensation::reduce(const Eigen::Ref<const Vector>& b, Eigen::Ref<Vector> rest) const {
  for (std::size_t r = 0; r < rest_unknown_.size(); ++r) rest[r] = b[rest_unknown_[r]];
  for (const Block& block : blocks_) {
    const DenseMap W = coupled(block);
    const auto own_b = b.segment(block.range.begin, block.range.size());
    for (int c = 0; c < W.cols(); ++c) rest[block_rest_[block.rest_begin + c]] -= W.col(c).dot(own_b);
  }
}

void Condensation::expand(const Eigen::Ref<const Vector>& b, const Eigen::Ref<const Vector>& rest,
                          Eigen::Ref<Vector> x) const {
  for (std::size_t r = 0; r < rest_unknown_.size(); ++r) x[rest_unknown_[r]] = rest[r];
  for (const Block& block : blocks_) {
    const DenseMap inverse = own(block), W = coupled(block);
    auto own_x = x.segment(block.range.begin, block.range.size());
    own_x.setZero();
    for (int j = 0; j < inverse.cols(); ++j) own_x += b[block.range.begin + j] * inverse.col(j);
    for (int c = 0; c < W.cols(); ++c) own_x -= rest[block_rest_[block.rest_begin + c]] * W.col(c);
  }
}

}  // namespace upbead::detail
