#include "products.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/lanes.h"

namespace upbead::detail {

namespace {

constexpr std::array fields = {Field::displacement, Field::relative_fluid, Field::pressure_impulse};
static_assert(static_cast<int>(fields[0]) == 0 && static_cast<int>(fields[1]) == 1 && static_cast<int>(fields[2]) == 2);

}  // namespace

SymmetricPair::SymmetricPair(const SparseMatrix& C, const SparseMatrix& K) : begin_{0} {
  const Vector of_C = C.diagonal(), of_K = K.diagonal();
  for (int i = 0; i < C.rows(); ++i) diagonal_.emplace_back(of_C[i], of_K[i]);
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
      const double of_c = take(c, column);
      entry_.emplace_back(of_c, take(k, column));
    }
    begin_.push_back(static_cast<int>(column_.size()));
  }
}

/// Both matrices at once, each in a lane of its own; two sums, so that no product waits for the one before.
void SymmetricPair::subtract_products(const Vector& v, const Vector& x, Vector& f) const {
  const auto n = static_cast<std::size_t>(v.size());
  vectors_.resize(n);
  products_.resize(n);
  for (std::size_t i = 0; i < n; ++i) vectors_[i] = Pair(v[static_cast<int>(i)], x[static_cast<int>(i)]);
  for (std::size_t i = 0; i < n; ++i) {
    const Pair own = vectors_[i];
    Pair even = diagonal_[i] * own, odd = Pair::Zero();
    const auto take = [&](int q, Pair& sum) {
      const int j = column_[q];
      sum += entry_[q] * vectors_[j];
      products_[j] += entry_[q] * own;
    };
    int q = begin_[i];
    for (; q + 1 < begin_[i + 1]; q += 2) {
      take(q, even);
      take(q + 1, odd);
    }
    if (q < begin_[i + 1]) take(q, even);
    products_[i] = even + odd;  // rows below have not added anything yet
  }
  for (std::size_t i = 0; i < n; ++i) f[static_cast<int>(i)] -= products_[i].sum();
}

namespace {

template <int n>
struct Doubles {
  using Type __attribute__((vector_size(n * sizeof(double)))) = double;
};

/// Columns [first, first + n) of Y = A X, of n_columns each.
template <int n>
UPBEAD_IN_CLONES void multiply_some(const SparseMatrix& A, const double* X, int n_columns, int first, double* Y) {
  using Values = typename Doubles<n>::Type;
  const int *begin = A.outerIndexPtr(), *column = A.innerIndexPtr();
  const double* value = A.valuePtr();
  for (std::ptrdiff_t i = 0; i < A.rows(); ++i) {
    Values sum{};
    for (int q = begin[i]; q < begin[i + 1]; ++q) {
      Values x;
      std::memcpy(&x, X + std::ptrdiff_t{column[q]} * n_columns + first, sizeof x);
      sum += value[q] * x;
    }
    std::memcpy(Y + i * n_columns + first, &sum, sizeof sum);
  }
}

UPBEAD_CLONES void multiply(const SparseMatrix& A, const double* X, int n_columns, double* Y) {
  int first = 0;
  for (; first + 8 <= n_columns; first += 8) multiply_some<8>(A, X, n_columns, first, Y);
  for (; first + 4 <= n_columns; first += 4) multiply_some<4>(A, X, n_columns, first, Y);
  for (; first < n_columns; ++first) multiply_some<1>(A, X, n_columns, first, Y);
}

}  // namespace

VectorBlock block_product(const SparseMatrix& A, const VectorBlock& X) {
  if (!A.isCompressed()) return A * X;
  VectorBlock Y(A.rows(), X.cols());
  multiply(A, X.data(), static_cast<int>(X.cols()), Y.data());
  return Y;
}

LowerTriangle::LowerTriangle(const SparseMatrix& A, const std::vector<Field>& field) : begin_{0} {
  diagonal_ = A.diagonal();
  for (int i = 0; i < A.rows(); ++i)
    for (const Field of : fields) {
      for (SparseMatrix::InnerIterator it(A, i); it && it.col() < i; ++it)
        if (field[static_cast<std::size_t>(it.col())] == of && it.value() != 0.) {
          column_.push_back(static_cast<int>(it.col()));
          entry_.push_back(it.value());
        }
      begin_.push_back(static_cast<int>(column_.size()));
    }
}

namespace {

/// Rows of one field times columns of another; what lies above the diagonal is the transpose of what lies below.
template <class Gram>
FieldGrams mirrored(const std::array<std::array<Gram, 3>, 3>& below) {
  std::array<Gram, 3> sum;
  for (int f = 0; f < 3; ++f) {
    sum[f].setZero();
    for (int g = 0; g < 3; ++g) sum[f] += below[f][g] + below[g][f].transpose();
  }
  return {sum[0], sum[1], -sum[2]};
}

}  // namespace

template <int n_columns>
FieldGrams LowerTriangle::grams_of(const VectorBlock& Z, const std::vector<Field>& field) const {
  using Column = Eigen::Matrix<double, n_columns, 1>;
  using Gram = Eigen::Matrix<double, n_columns, n_columns>;
  std::array<std::array<Gram, 3>, 3> below;
  for (auto& grams : below)
    for (Gram& gram : grams) gram.setZero();
  const auto row = [&](int i) { return Eigen::Map<const Column>(Z.data() + std::ptrdiff_t{n_columns} * i); };
  for (int i = 0; i < Z.rows(); ++i) {
    const auto own = static_cast<std::size_t>(field[static_cast<std::size_t>(i)]);
    const int* begin = begin_.data() + 3 * std::ptrdiff_t{i};
    for (std::size_t of = 0; of < 3; ++of) {
      const double half = of == own ? 0.5 * diagonal_[i] : 0.;
      if (begin[of] == begin[of + 1] && half == 0.) continue;
      Column product = half * row(i);
      for (int q = begin[of]; q < begin[of + 1]; ++q) product += entry_[q] * row(column_[q]);
      below[own][of] += row(i) * product.transpose();
    }
  }
  return mirrored(below);
}

FieldGrams LowerTriangle::grams(const VectorBlock& Z, const std::vector<Field>& field) const {
  switch (Z.cols()) {
    case 1:
      return grams_of<1>(Z, field);
    case 2:
      return grams_of<2>(Z, field);
    case 3:
      return grams_of<3>(Z, field);
    case 4:
      return grams_of<4>(Z, field);
    case 6:
      return grams_of<6>(Z, field);
    default:
      throw std::logic_error("grams: not a block of 1, 2, 3, 4 or 6 vectors");
  }
}

}  // namespace upbead::detail
