#include "symmetric_pair.h"

#include <algorithm>

namespace upbead::detail {

SymmetricPair::SymmetricPair(const SparseMatrix& C, const SparseMatrix& K)
    : begin_{0}, diagonal_C_(C.diagonal()), diagonal_K_(K.diagonal()) {
  const auto take = [](SparseMatrix::InnerIterator& it, int column) {
    if (!it || it.col() != column) return 0.;
    const double value = it.value();
    ++it;
    return value;
  };
  for (int i = 0; i < C.rows(); ++i) {
    SparseMatrix::InnerIterator c(C, i), k(K, i);
    const auto next = [i](const SparseMatrix::InnerIterator& it) { return it ? static_cast<int>(it.col()) : i; };
    for (int column = std::min(next(c), next(k)); column < i; column = std::min(next(c), next(k))) {
      column_.push_back(column);
      entry_.push_back({take(c, column), take(k, column)});
    }
    begin_.push_back(static_cast<int>(column_.size()));
  }
}

void SymmetricPair::subtract_products(const Vector& v, const Vector& x, Vector& f) const {
  for (int i = 0; i < v.size(); ++i) {
    const double v_i = v[i], x_i = x[i];
    double sum = diagonal_C_[i] * v_i + diagonal_K_[i] * x_i;
    for (int q = begin_[i]; q < begin_[i + 1]; ++q) {
      const auto [c, k] = entry_[q];
      const int j = column_[q];
      sum += c * v[j] + k * x[j];
      f[j] -= c * v_i + k * x_i;
    }
    f[i] -= sum;
  }
}

}  // namespace upbead::detail
