#include "products.h"

#include <algorithm>
#include <array>
#include <stdexcept>

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

namespace {

/// With the number of columns known to the compiler, a row costs little more than one product.
template <int n_columns>
FieldGrams grams_of(const SparseMatrix& A, const VectorBlock& Z, const std::vector<Field>& field) {
  using Column = Eigen::Matrix<double, n_columns, 1>;
  using Gram = Eigen::Matrix<double, n_columns, n_columns>;
  std::array<Gram, 3> sum;
  for (Gram& gram : sum) gram.setZero();
  const auto row = [&](int i) { return Eigen::Map<const Column>(Z.data() + std::ptrdiff_t{n_columns} * i); };
  for (int i = 0; i < A.rows(); ++i) {
    SparseMatrix::InnerIterator it(A, i);
    if (!it) continue;  // as most rows of what the sides radiate
    Column product = Column::Zero();
    for (; it; ++it) product += it.value() * row(static_cast<int>(it.col()));
    sum[static_cast<std::size_t>(field[i])] += row(i) * product.transpose();
  }
  return {sum[0], sum[1], -sum[2]};
}

static_assert(static_cast<int>(Field::displacement) == 0 && static_cast<int>(Field::relative_fluid) == 1 &&
              static_cast<int>(Field::pressure_impulse) == 2);

}  // namespace

FieldGrams grams(const SparseMatrix& A, const VectorBlock& Z, const std::vector<Field>& field) {
  switch (Z.cols()) {
    case 1:
      return grams_of<1>(A, Z, field);
    case 2:
      return grams_of<2>(A, Z, field);
    case 3:
      return grams_of<3>(A, Z, field);
    case 4:
      return grams_of<4>(A, Z, field);
    case 6:
      return grams_of<6>(A, Z, field);
    default:
      throw std::logic_error("grams: not a block of 1, 2, 3, 4 or 6 vectors");
  }
}

}  // namespace upbead::detail
