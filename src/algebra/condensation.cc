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
    blocks_.push_back({range, {}, {}, {}});
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
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    Block& block = blocks_[k];
    for (int i = block.range.begin; i < block.range.end; ++i)
      for (SparseMatrix::InnerIterator it(A, i); it; ++it) {
        const int j = static_cast<int>(it.col()), other = block_of_[j];
        if (other < 0)
          block.rest.push_back(rest_index_[j]);
        else if (other != static_cast<int>(k) && it.value() != 0.)
          throw std::invalid_argument("blocks " + std::to_string(k) + " and " + std::to_string(other) + " couple");
      }
    std::sort(block.rest.begin(), block.rest.end());
    block.rest.erase(std::unique(block.rest.begin(), block.rest.end()), block.rest.end());
    for (std::size_t c = 0; c < block.rest.size(); ++c)
      touching_[block.rest[c]].emplace_back(static_cast<int>(k), static_cast<int>(c));
  }
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
      for (int column : blocks_[k].rest) add(column);
    std::sort(row.begin(), row.end());
    inner.insert(inner.end(), row.begin(), row.end());
    outer.push_back(static_cast<int>(inner.size()));
  }
  const std::vector<double> zeros(inner.size(), 0.);
  schur_ = Eigen::Map<const SparseMatrix>(n, n, outer.back(), outer.data(), inner.data(), zeros.data());
}

void Condensation::factorise(const SparseMatrix& A, Block& block) const {
  const int n = block.range.size();
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(n, n);
  block.coupled.setZero(n, static_cast<Eigen::Index>(block.rest.size()));
  for (int i = 0; i < n; ++i)
    for (SparseMatrix::InnerIterator it(A, block.range.begin + i); it; ++it) {
      const int j = static_cast<int>(it.col());
      if (block_of_[j] >= 0) {
        if (block_of_[j] == block_of_[block.range.begin]) own(i, j - block.range.begin) = it.value();
        continue;
      }
      const auto place = std::lower_bound(block.rest.begin(), block.rest.end(), rest_index_[j]);
      block.coupled(i, place - block.rest.begin()) = it.value();
    }
  const Eigen::LLT<Eigen::MatrixXd> llt(own);
  if (llt.info() != Eigen::Success || !(llt.matrixLLT().diagonal().array() > 0.).all())
    throw NumericsError("the cell block of unknowns " + std::to_string(block.range.begin) + " to " +
                        std::to_string(block.range.end - 1) + " is not positive definite");
  block.lower = llt.matrixL();
  block.lower.triangularView<Eigen::Lower>().solveInPlace(block.coupled);
}

void Condensation::condense(const SparseMatrix& A) {
  for (Block& block : blocks_) factorise(A, block);
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
      const Block& block = blocks_[k];
      for (std::size_t d = 0; d < block.rest.size(); ++d)
        schur_.valuePtr()[place[block.rest[d]]] -=
            block.coupled.col(c).dot(block.coupled.col(static_cast<Eigen::Index>(d)));
    }
  }
}

void Condensation::reduce(const Eigen::Ref<const Vector>& b, Vector& local, Vector& rest) const {
  for (std::size_t r = 0; r < rest_unknown_.size(); ++r) rest[r] = b[rest_unknown_[r]];
  Eigen::Index at = 0;
  for (const Block& block : blocks_) {
    auto z = local.segment(at, block.range.size());
    z = b.segment(block.range.begin, block.range.size());
    block.lower.triangularView<Eigen::Lower>().solveInPlace(z);
    for (std::size_t c = 0; c < block.rest.size(); ++c)
      rest[block.rest[c]] -= block.coupled.col(static_cast<Eigen::Index>(c)).dot(z);
    at += block.range.size();
  }
}

void Condensation::expand(const Vector& local, const Vector& rest, Eigen::Ref<Vector> x) const {
  for (std::size_t r = 0; r < rest_unknown_.size(); ++r) x[rest_unknown_[r]] = rest[r];
  Eigen::Index at = 0;
  for (const Block& block : blocks_) {
    auto own = x.segment(block.range.begin, block.range.size());
    own = local.segment(at, block.range.size());
    for (std::size_t c = 0; c < block.rest.size(); ++c)
      own -= rest[block.rest[c]] * block.coupled.col(static_cast<Eigen::Index>(c));
    block.lower.triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    at += block.range.size();
  }
}

}  // namespace upbead::detail
