#include "algebra/factorisation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "algebra/fail_together.h"
#include "algebra/ldlt/ldlt.h"
#include "condensation.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Number of right-hand sides solved together: their fronts and a slab still fit in the nearest caches.
constexpr Eigen::Index columns_at_once = 8;

/// Of each row, the diagonal entry and the largest magnitude.
struct RowSizes {
  Vector diagonal, largest;
};

RowSizes row_sizes(const SparseMatrix& A) {
  RowSizes sizes{Vector::Zero(A.rows()), Vector::Zero(A.rows())};
  for (int i = 0; i < A.rows(); ++i)
    for (SparseMatrix::InnerIterator it(A, i); it; ++it) {
      if (it.col() == i) sizes.diagonal[i] = it.value();
      sizes.largest[i] = std::max(sizes.largest[i], std::abs(it.value()));
    }
  return sizes;
}

/// All processes must scale a shared unknown alike. The sum of the processes' largest entries serves in place of
/// their maximum.
void sum_shared(const Sharing& sharing, RowSizes& sizes) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(sharing.n_all, 2);
  for (std::size_t k = 0; k < sharing.unknowns.size(); ++k) {
    values(sharing.numbers[k], 0) = sizes.diagonal[sharing.unknowns[k]];
    values(sharing.numbers[k], 1) = sizes.largest[sharing.unknowns[k]];
  }
  sharing.processes->sum(values.data(), static_cast<int>(values.size()));
  for (std::size_t k = 0; k < sharing.unknowns.size(); ++k) {
    sizes.diagonal[sharing.unknowns[k]] = values(sharing.numbers[k], 0);
    sizes.largest[sharing.unknowns[k]] = values(sharing.numbers[k], 1);
  }
}

/// 1 / sqrt|a_ii|; where a_ii = 0, with the largest magnitude of the row in its place.
Vector equilibration(const SparseMatrix& A, const Sharing& sharing) {
  RowSizes sizes = row_sizes(A);
  if (sharing.n_all > 0) sum_shared(sharing, sizes);
  Vector scale(A.rows());
  detail::fail_together(sharing, [&] {
    for (int i = 0; i < A.rows(); ++i) {
      const double diagonal = std::abs(sizes.diagonal[i]), largest = sizes.largest[i];
      if (largest == 0.) throw NumericsError("the matrix is singular: row " + std::to_string(i) + " is empty");
      scale[i] = 1. / std::sqrt(diagonal > 0. ? diagonal : largest);
    }
  });
  return scale;
}

/// The sharing, with the numbers of the unknowns that are left once the blocks are condensed.
Sharing condensed(const detail::Condensation& condensation, Sharing sharing) {
  for (int& i : sharing.unknowns) {
    i = condensation.rest_index(i);
    if (i < 0) throw std::invalid_argument("a block holds a shared unknown");
  }
  return sharing;
}

void check_finite(const SparseMatrix& A) {
  const Eigen::Map<const Eigen::ArrayXd> values(A.valuePtr(), A.nonZeros());
  if (!values.isFinite().all()) throw NumericsError("the matrix holds a number that is not finite");
}

/// FNV-1a hash of the pattern, to notice a matrix with another pattern than the one analysed.
std::size_t fingerprint(const SparseMatrix& A) {
  std::size_t hash = 14695981039346656037ULL;
  const auto add = [&](int value) { hash = (hash ^ static_cast<std::size_t>(value)) * 1099511628211ULL; };
  for (int i = 0; i <= A.rows(); ++i) add(A.outerIndexPtr()[i]);
  for (Eigen::Index k = 0; k < A.nonZeros(); ++k) add(A.innerIndexPtr()[k]);
  return hash;
}

/// Number of steps of iterative refinement (Higham, Accuracy and Stability of Numerical Algorithms, 2002, ch. 12)
/// that reduce a residual of `growth` units of round-off to about a hundred units; 0 where growth is at most a
/// thousand.
int refinements(double growth) {
  constexpr double tolerable = 1e3, largest = 1e13, epsilon = std::numeric_limits<double>::epsilon();
  if (growth <= tolerable) return 0;
  return static_cast<int>(std::ceil(std::log(100. * epsilon) / std::log(std::min(growth, largest) * epsilon))) - 1;
}

/// How much larger the diagonal of the Schur complement S is than that of A. For a pressure, A holds its storage, and
/// S also the flow within a step: where the flow is far larger, S loses digits of the storage, which matter in a
/// closed box.
double lost_in(const SparseMatrix& S, const SparseMatrix& A, const detail::Condensation& condensation) {
  double largest = 1.;
  if (condensation.n_local() == 0) return largest;
  const Vector diagonal = A.diagonal();
  for (int i = 0; i < A.rows(); ++i)
    if (const int rest = condensation.rest_index(i); rest >= 0 && diagonal[i] != 0.)
      largest = std::max(largest, std::abs(S.coeff(rest, rest) / diagonal[i]));
  return largest;
}

/// The sum is the same on all processes, so that all refine alike.
double sum_of(double value, const Sharing& sharing) {
  if (sharing.processes) sharing.processes->sum(&value, 1);
  return value;
}

const SparseMatrix& checked(const SparseMatrix& A) {
  if (A.rows() != A.cols() || !A.isCompressed()) throw std::invalid_argument("a square, compressed matrix is needed");
  return A;
}

}  // namespace

struct Factorisation::Impl {
  /// A matrix that the caller gives up, and how it is had anew; or nothing.
  struct Spent {
    SparseMatrix* matrix = nullptr;
    Again again;
  };

  Impl(const SparseMatrix& A, const std::vector<IndexRange>& blocks, const Sharing& shared, const Spent& spent)
      : pattern(fingerprint(checked(A))),
        condensation(A, blocks),
        sharing(condensed(condensation, shared)),
        ldlt(condensation.schur(), sharing) {
    factorise(A, spent);
  }

  void factorise(const SparseMatrix& A, const Spent& spent) {
    detail::fail_together(sharing, [&] {
      check_finite(A);
      condensation.condense(A);
    });
    const double lost = lost_in(condensation.schur(), A, condensation);
    if (spent.matrix != nullptr) SparseMatrix().swap(*spent.matrix);
    ldlt.factorise(condensation.schur(), equilibration(condensation.schur(), sharing));
    finish(A, spent, sum_of(lost, sharing));
  }

  /// Sees how far solutions must be refined.
  void finish(const SparseMatrix& A, const Spent& spent, double lost) {
    constexpr double tolerable_loss = 1e8;
    n_refinements = std::max(refinements(sum_of(ldlt.growth(), sharing)), lost > tolerable_loss ? 1 : 0);
    const bool stands_in = ldlt.n_stand_ins() > 0;
    SparseMatrix kept;
    if (n_refinements > 0 || stands_in) kept = spent.matrix != nullptr ? spent.again() : A;
    matrix.swap(kept);
    if (stands_in) refine_until_exact();
    inertia = inertia_of_all();
  }

  void require_pattern(const SparseMatrix& A) const {
    if (fingerprint(checked(A)) != pattern) throw std::invalid_argument("refactor: the pattern differs");
  }

  Inertia inertia_of_all() const {
    const Inertia own = ldlt.inertia(), shared = ldlt.shared_inertia();
    std::array<double, 2> eliminated{static_cast<double>(own.positive + condensation.n_local()),
                                     static_cast<double>(own.negative)};
    if (sharing.processes) sharing.processes->sum(eliminated.data(), 2);
    return {static_cast<int>(eliminated[0]) + shared.positive, static_cast<int>(eliminated[1]) + shared.negative};
  }

  /// After zero pivots were replaced: finds how many refinements an irregular right-hand side needs. If the matrix is
  /// singular, such a right-hand side has a part that no solution can give, and the residual stays.
  void refine_until_exact() {
    constexpr int most = 20;
    constexpr double exact = 1e-13, shrinking = 0.5;
    Eigen::MatrixXd b(matrix.rows(), 1), x(matrix.rows(), 1), correction(matrix.rows(), 1);
    const Vector scale = equilibration(matrix, {});
    for (Eigen::Index i = 0; i < b.rows(); ++i) b(i, 0) = std::sin(1. + static_cast<double>(i * i % 9973)) / scale[i];
    const auto size = [&](const Eigen::MatrixXd& r) { return r.col(0).cwiseProduct(scale).norm(); };
    solve_once(b, x);
    Eigen::MatrixXd residual = b - matrix * x;
    double last = size(residual);
    for (int done = 1; done <= most; ++done) {
      solve_once(residual, correction);
      x += correction;
      residual = b - matrix * x;
      const double now = size(residual);
      n_refinements = std::max(n_refinements, done);
      if (now <= exact * (size(b) + x.col(0).cwiseQuotient(scale).norm())) return;
      if (!(now < shrinking * last)) break;
      last = now;
    }
    throw NumericsError("the matrix is singular: " + std::to_string(ldlt.n_stand_ins()) +
                        " of its pivots are zero (is a part of the scene not held, or a pressure nowhere given?)");
  }

  void solve(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::Ref<Eigen::MatrixXd> X) {
    solve_once(B, X);
    if (n_refinements == 0) return;
    Eigen::MatrixXd residual, correction(X.rows(), X.cols());
    for (int i = 0; i < n_refinements; ++i) {
      residual = B - matrix * X;
      solve_once(residual, correction);
      X += correction;
    }
  }

  void solve_once(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::Ref<Eigen::MatrixXd> X) {
    const Eigen::Index n_rest = condensation.n_rest();
    rest.resize(n_rest, B.cols());
    for (Eigen::Index c = 0; c < B.cols(); ++c) condensation.reduce(B.col(c), rest.col(c));
    ldlt.solve(rest, rest);
    for (Eigen::Index c = 0; c < B.cols(); ++c) condensation.expand(B.col(c), rest.col(c), X.col(c));
  }

  Border border(const SparseMatrix& columns);

  std::size_t pattern;
  detail::Condensation condensation;
  Sharing sharing;  ///< among the unknowns of the Schur complement
  detail::Ldlt ldlt;
  Inertia inertia;
  int n_refinements = 0;  ///< refinement steps of each solution
  SparseMatrix matrix;    ///< A, kept where solutions are refined
  Eigen::MatrixXd rest;   ///< work space of a solve
};

/// Elimination fills few rows of a column with few entries: those above the entries in the elimination tree.
Border Factorisation::Impl::border(const SparseMatrix& columns) {
  using Triplets = std::vector<Eigen::Triplet<double>>;
  const Eigen::Index m = columns.cols();
  Border border{columns, {}, {}, {}, SparseMatrix(m, columns.rows()), {}};
  const Eigen::SparseMatrix<double> by_columns = columns;
  Triplets halfway, in_blocks;
  std::vector<int> place(static_cast<std::size_t>(condensation.n_rest()), -1);
  Vector b(columns.rows()), x(columns.rows());
  const Vector none = Vector::Zero(condensation.n_rest());
  for (Eigen::Index first = 0; first < m; first += columns_at_once) {
    const Eigen::Index n = std::min(columns_at_once, m - first);
    rest.resize(condensation.n_rest(), n);
    for (Eigen::Index c = 0; c < n; ++c) {
      b = by_columns.col(first + c);
      condensation.reduce(b, rest.col(c));
      condensation.expand(b, none, x);
      for (Eigen::Index i = 0; i < x.size(); ++i)
        if (x[i] != 0.) in_blocks.emplace_back(first + c, i, x[i]);
    }
    ldlt.begin(rest);
    const auto half = ldlt.halfway(n);
    for (Eigen::Index c = 0; c < n; ++c)
      for (Eigen::Index i = 0; i < half.rows(); ++i)
        if (half(i, c) != 0.) {
          if (place[i] < 0) {
            place[i] = static_cast<int>(border.rows.size());
            border.rows.push_back(static_cast<int>(i));
          }
          halfway.emplace_back(place[i], first + c, half(i, c));
        }
  }
  border.halfway.resize(static_cast<Eigen::Index>(border.rows.size()), m);
  border.halfway.setFromTriplets(halfway.begin(), halfway.end());
  border.in_blocks.setFromTriplets(in_blocks.begin(), in_blocks.end());
  border.pivot = ldlt.inverse_pivot()(border.rows).cwiseInverse();
  const Eigen::MatrixXd dense = border.halfway;
  border.gram = dense.transpose() * border.pivot.asDiagonal() * dense;
  border.gram += Eigen::MatrixXd(border.in_blocks * columns);
  return border;
}

Factorisation::Factorisation(const SparseMatrix& A, const std::vector<IndexRange>& blocks, const Sharing& sharing)
    : impl_(std::make_unique<Impl>(A, blocks, sharing, Impl::Spent{nullptr, {}})) {}
Factorisation::Factorisation(SparseMatrix&& A, const std::vector<IndexRange>& blocks, const Sharing& sharing,
                             const Again& again)
    : impl_(std::make_unique<Impl>(A, blocks, sharing, Impl::Spent{&A, again})) {}
Factorisation::~Factorisation() = default;
Factorisation::Factorisation(Factorisation&&) noexcept = default;
Factorisation& Factorisation::operator=(Factorisation&&) noexcept = default;

void Factorisation::refactor(const SparseMatrix& A) {
  impl_->require_pattern(A);
  impl_->factorise(A, {nullptr, {}});
}

void Factorisation::refactor(SparseMatrix&& A, const Again& again) {
  impl_->require_pattern(A);
  impl_->factorise(A, {&A, again});
}

Vector Factorisation::solve(const Vector& b) const {
  Vector x(b.size());
  impl_->solve(b, x);
  return x;
}

void Factorisation::solve(const Eigen::Ref<const Vector>& b, Eigen::Ref<Vector> x) const {
  impl_->solve(b, x);
}

Eigen::MatrixXd Factorisation::solve_columns(const Eigen::MatrixXd& B) const {
  Eigen::MatrixXd X(B.rows(), B.cols());
  for (Eigen::Index c = 0; c < B.cols(); c += columns_at_once) {
    const Eigen::Index n = std::min(columns_at_once, B.cols() - c);
    impl_->solve(B.middleCols(c, n), X.middleCols(c, n));
  }
  return X;
}

bool Factorisation::has_halves() const {
  return impl_->n_refinements == 0 && !impl_->sharing.processes;
}

Border Factorisation::border(const SparseMatrix& columns) const {
  return impl_->border(columns);
}

Vector Factorisation::begin(const Eigen::Ref<const Vector>& b, const Border& border) const {
  impl_->rest.resize(impl_->condensation.n_rest(), 1);
  impl_->condensation.reduce(b, impl_->rest.col(0));
  impl_->ldlt.begin(impl_->rest);
  const Vector reached = impl_->ldlt.halfway(1).col(0)(border.rows).cwiseProduct(border.pivot);
  return border.halfway.transpose() * reached + border.in_blocks * b;
}

void Factorisation::finish(Eigen::Ref<Vector> b, const Border& border, const Vector& q, Eigen::Ref<Vector> x) const {
  if (!q.isZero(0.)) {
    auto half = impl_->ldlt.halfway(1).col(0);
    const Vector change = border.halfway * q;
    for (std::size_t k = 0; k < border.rows.size(); ++k) half[border.rows[k]] -= change[static_cast<Eigen::Index>(k)];
    b -= border.columns * q;
  }
  impl_->ldlt.finish(impl_->rest);
  impl_->condensation.expand(b, impl_->rest.col(0), x);
}

Inertia Factorisation::inertia() const {
  return impl_->inertia;
}

long Factorisation::n_factor_entries() const {
  return impl_->ldlt.n_factor_entries();
}

}  // namespace upbead
