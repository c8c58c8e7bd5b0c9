#include "upbead/algebra/factorisation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "condensation.h"
#include "ldlt.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// 1 / sqrt|a_ii|, or where a_ii = 0 the largest entry of the row in its place.
Vector equilibration(const SparseMatrix& A) {
  Vector scale(A.rows());
  for (int i = 0; i < A.rows(); ++i) {
    double diagonal = 0., largest = 0.;
    for (SparseMatrix::InnerIterator it(A, i); it; ++it) {
      if (it.col() == i) diagonal = std::abs(it.value());
      largest = std::max(largest, std::abs(it.value()));
    }
    if (largest == 0.) throw NumericsError("the matrix is singular: row " + std::to_string(i) + " is empty");
    scale[i] = 1. / std::sqrt(diagonal > 0. ? diagonal : largest);
  }
  return scale;
}

void scale_rows_and_columns(SparseMatrix& A, const Vector& scale) {
  for (int i = 0; i < A.rows(); ++i)
    for (SparseMatrix::InnerIterator it(A, i); it; ++it) it.valueRef() *= scale[i] * scale[it.col()];
}

void check_finite(const SparseMatrix& A) {
  const Eigen::Map<const Eigen::ArrayXd> values(A.valuePtr(), A.nonZeros());
  if (!values.isFinite().all()) throw NumericsError("the matrix holds a number that is not finite");
}

/// FNV-1a of the pattern, to notice that a matrix is not the one that was analysed.
std::size_t fingerprint(const SparseMatrix& A) {
  std::size_t hash = 14695981039346656037ULL;
  const auto add = [&](int value) { hash = (hash ^ static_cast<std::size_t>(value)) * 1099511628211ULL; };
  for (int i = 0; i <= A.rows(); ++i) add(A.outerIndexPtr()[i]);
  for (Eigen::Index k = 0; k < A.nonZeros(); ++k) add(A.innerIndexPtr()[k]);
  return hash;
}

const SparseMatrix& checked(const SparseMatrix& A) {
  if (A.rows() != A.cols() || !A.isCompressed()) throw std::invalid_argument("a square, compressed matrix is needed");
  return A;
}

}  // namespace

struct Factorisation::Impl {
  Impl(const SparseMatrix& A, const std::vector<IndexRange>& blocks)
      : pattern(fingerprint(checked(A))), condensation(A, blocks), ldlt(condensation.schur()) {
    const int n_rest = condensation.n_rest();
    local.resize(A.rows() - n_rest);
    rest.resize(n_rest);
    solution.resize(n_rest);
    factorise(A);
  }

  void factorise(const SparseMatrix& A) {
    check_finite(A);
    condensation.condense(A);
    scale = equilibration(condensation.schur());
    scale_rows_and_columns(condensation.schur(), scale);
    ldlt.factorise();
  }

  void solve(const Eigen::Ref<const Vector>& b, Eigen::Ref<Vector> x) {
    condensation.reduce(b, local, rest);
    rest.array() *= scale.array();
    ldlt.solve(rest, solution);
    solution.array() *= scale.array();
    condensation.expand(local, solution, x);
  }

  std::size_t pattern;
  detail::Condensation condensation;
  detail::Ldlt ldlt;
  Vector scale;
  Vector local, rest, solution;  ///< work space of a solve
};

Factorisation::Factorisation(const SparseMatrix& A, const std::vector<IndexRange>& blocks)
    : impl_(std::make_unique<Impl>(A, blocks)) {}
Factorisation::~Factorisation() = default;
Factorisation::Factorisation(Factorisation&&) noexcept = default;
Factorisation& Factorisation::operator=(Factorisation&&) noexcept = default;

void Factorisation::refactor(const SparseMatrix& A) {
  if (fingerprint(checked(A)) != impl_->pattern) throw std::invalid_argument("refactor: the pattern differs");
  impl_->factorise(A);
}

Vector Factorisation::solve(const Vector& b) const {
  Vector x(b.size());
  impl_->solve(b, x);
  return x;
}

void Factorisation::solve(const Eigen::Ref<const Vector>& b, Eigen::Ref<Vector> x) const {
  impl_->solve(b, x);
}

Inertia Factorisation::inertia() const {
  Inertia total = impl_->ldlt.inertia();
  total.positive += static_cast<int>(impl_->local.size());
  return total;
}

long Factorisation::n_factor_entries() const {
  return impl_->ldlt.n_factor_entries();
}

}  // namespace upbead
