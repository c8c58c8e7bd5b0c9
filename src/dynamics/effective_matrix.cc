#include "effective_matrix.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

constexpr std::size_t kept_matrices = 3;

/// Calls see(row, column, value) for the entries of m M + c C + k K, in their order.
template <class See>
void for_each_entry(const System& system, const EffectiveCoefficients& e, const See& see) {
  using Entry = SparseMatrix::InnerIterator;
  const auto column = [](const Entry& it) { return it ? static_cast<int>(it.col()) : std::numeric_limits<int>::max(); };
  const auto take = [&](Entry& it, int at) {
    if (column(it) != at) return 0.;
    const double value = it.value();
    ++it;
    return value;
  };
  for (int i = 0; i < system.size(); ++i) {
    Entry m(system.M, i), c(system.C, i), k(system.K, i);
    while (m || c || k) {
      const int at = std::min({column(m), column(c), column(k)});
      const double of_m = take(m, at), of_c = take(c, at), of_k = take(k, at);
      see(i, at, e.m * of_m + e.c * of_c + e.k * of_k);
    }
  }
}

/// In as much memory as it needs; Eigen's own sum takes up to three times as much on the way.
SparseMatrix combine(const System& system, const EffectiveCoefficients& e) {
  Eigen::Index n_entries = 0;
  for_each_entry(system, e, [&](int, int, double) { ++n_entries; });
  SparseMatrix E(system.size(), system.size());
  E.resizeNonZeros(n_entries);
  int next = 0;
  for_each_entry(system, e, [&](int row, int column, double value) {
    E.innerIndexPtr()[next] = column;
    E.valuePtr()[next] = value;
    E.outerIndexPtr()[row + 1] = ++next;
  });
  for (int i = 0; i < system.size(); ++i)  // rows without entries
    E.outerIndexPtr()[i + 1] = std::max(E.outerIndexPtr()[i + 1], E.outerIndexPtr()[i]);
  return E;
}

/// The columns from `begin` to `end` of the first rows; Eigen's own blocks would copy twice, once for rows, once for
/// columns.
SparseMatrix columns_of(const SparseMatrix& E, int n_rows, int begin, int end) {
  SparseMatrix part(n_rows, end - begin);
  std::vector<std::pair<int, int>> range;  // of entries, by row
  int n = 0;
  for (int i = 0; i < n_rows; ++i) {
    const int *columns = E.innerIndexPtr(), *first = columns + E.outerIndexPtr()[i],
              *last = columns + E.outerIndexPtr()[i + 1];
    const int *from = std::lower_bound(first, last, begin), *to = std::lower_bound(from, last, end);
    range.emplace_back(static_cast<int>(from - columns), static_cast<int>(to - columns));
    part.outerIndexPtr()[i] = n;
    n += static_cast<int>(to - from);
  }
  part.outerIndexPtr()[n_rows] = n;
  part.resizeNonZeros(n);
  int next = 0;
  for (const auto& [from, to] : range)
    for (int k = from; k < to; ++k, ++next) {
      part.innerIndexPtr()[next] = E.innerIndexPtr()[k] - begin;
      part.valuePtr()[next] = E.valuePtr()[k];
    }
  return part;
}

SparseMatrix free_rows_of_prescribed(const SparseMatrix& E, int n_free) {
  return columns_of(E, n_free, n_free, static_cast<int>(E.cols()));
}

/// Makes E its block of the free unknowns.
SparseMatrix& cut(SparseMatrix& E, int n_free) {
  if (E.cols() > n_free) columns_of(E, n_free, 0, n_free).swap(E);
  return E;
}

bool operator==(const EffectiveCoefficients& a, const EffectiveCoefficients& b) {
  return a.m == b.m && a.c == b.c && a.k == b.k;
}

}  // namespace

EffectiveMatrix::EffectiveMatrix(const System& system, const EffectiveCoefficients& coefficients, bool refined)
    : EffectiveMatrix(system, combine(system, coefficients), refined, [&] { return combine(system, coefficients); }) {}

EffectiveMatrix::EffectiveMatrix(const System& system, const SparseMatrix& E, bool refined)
    : EffectiveMatrix(system, SparseMatrix(E), refined, [&] { return E; }) {}

EffectiveMatrix::EffectiveMatrix(const System& system, SparseMatrix&& E, bool refined,
                                 const Factorisation::Again& again)
    : n_free_(system.n_free()),
      refined_(refined),
      layout_(system.sharing.processes, {}),
      coupling_(free_rows_of_prescribed(E, n_free_)),
      prescribed_(E.bottomRows(system.n_prescribed)),
      free_(refined ? cut(E, n_free_) : SparseMatrix()),
      factors_(std::move(cut(E, n_free_)), system.blocks, system.sharing, free_again(again)) {
  check_inertia(system);
}

Factorisation::Again EffectiveMatrix::free_again(const Factorisation::Again& again) const {
  return [n_free = n_free_, &again] {
    SparseMatrix E = again();
    cut(E, n_free);
    return E;
  };
}

void EffectiveMatrix::refactor(const System& system, const EffectiveCoefficients& coefficients) {
  SparseMatrix E = combine(system, coefficients);
  coupling_ = free_rows_of_prescribed(E, n_free_);
  prescribed_ = E.bottomRows(system.n_prescribed);
  cut(E, n_free_);
  if (refined_) free_ = E;
  factors_.refactor(std::move(E), free_again([&] { return combine(system, coefficients); }));
  check_inertia(system);
}

void EffectiveMatrix::check_inertia(const System& system) const {
  const auto n_phi = std::count(system.field.begin(), system.field.begin() + n_free_, Field::pressure_impulse) +
                     system.part.n_phi_elsewhere;
  const int negative = factors_.inertia().negative;
  if (negative != n_phi)
    throw NumericsError("the effective matrix has " + std::to_string(negative) +
                        " negative pivots where the pressure has " + std::to_string(n_phi) +
                        " unknowns: the system is not well posed or beyond double precision");
}

void EffectiveMatrix::solve(Vector& rhs, Vector& y) const {
  if (coupling_.cols() > 0) rhs.head(n_free_) -= coupling_ * y.tail(coupling_.cols());
  factors_.solve(rhs.head(n_free_), y.head(n_free_));
  if (!refined_) return;
  residual_ = rhs.head(n_free_) - free_ * y.head(n_free_);
  correction_.resize(n_free_);
  factors_.solve(residual_, correction_);
  y.head(n_free_) += correction_;
}

Vector EffectiveMatrix::residual_of_last(int n, const Vector& rhs, const Vector& y) const {
  Vector residual = prescribed_.bottomRows(n) * y - rhs.tail(n);
  layout_.add_up(residual);
  return residual;
}

Eigen::MatrixXd EffectiveMatrix::condensed_on_last(int n, const std::optional<Border>& border) const {
  const Eigen::MatrixXd own = SparseMatrix(prescribed_.bottomRows(n)).rightCols(n);
  Eigen::MatrixXd D = own;
  if (border) {
    D -= border->gram;
  } else {
    const Eigen::MatrixXd columns = coupling_.rightCols(n);
    D -= columns.transpose() * factors_.solve_columns(columns);
  }
  layout_.add_up(D);
  return 0.5 * (D + D.transpose());
}

std::optional<Border> EffectiveMatrix::border_of_last(int n) const {
  if (refined_ || !factors_.has_halves()) return std::nullopt;
  return factors_.border(coupling_.rightCols(n));
}

Vector EffectiveMatrix::begin(const Border& border, Vector& rhs, Vector& y) const {
  const Eigen::Index n = border.columns.cols(), n_prescribed = coupling_.cols();
  rhs.head(n_free_) -= coupling_ * y.tail(n_prescribed);
  y.head(n_free_).setZero();
  return factors_.begin(rhs.head(n_free_), border) + residual_of_last(static_cast<int>(n), rhs, y);
}

void EffectiveMatrix::finish(const Border& border, const Vector& change, Vector& rhs, Vector& y) const {
  y.tail(change.size()) += change;
  factors_.finish(rhs.head(n_free_), border, change, y.head(n_free_));
}

/// Puts the factorised matrix of these coefficients at the front of the list.
void EffectiveMatrices::factorise(const EffectiveCoefficients& coefficients) {
  const Stopwatch watch;
  if (entries_.size() < kept_matrices) {
    entries_.push_front({coefficients, EffectiveMatrix(system_, coefficients, refined_)});
  } else {
    entries_.splice(entries_.begin(), entries_, std::prev(entries_.end()));
    entries_.front().matrix.refactor(system_, coefficients);
    entries_.front().coefficients = coefficients;
  }
  ++n_factorisations_;
  seconds_ += watch.seconds();
}

const EffectiveMatrix& EffectiveMatrices::get(const EffectiveCoefficients& coefficients) {
  const auto same = [&](const Entry& entry) { return entry.coefficients == coefficients; };
  const auto found = std::find_if(entries_.begin(), entries_.end(), same);
  if (found == entries_.end()) {
    factorise(coefficients);
  } else {
    entries_.splice(entries_.begin(), entries_, found);
  }
  return entries_.front().matrix;
}

}  // namespace upbead::detail
