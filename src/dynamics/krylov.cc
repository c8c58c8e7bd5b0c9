#include "upbead/dynamics/krylov.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

#include "algebra/dense.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "dynamics/slip_row.h"
#include "effective_matrix.h"
#include "orthogonalise.h"
#include "products.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

namespace detail {

/// Spaces on two threads may have the same matrices, one at a time.
struct KrylovMatrices {
  KrylovMatrices(const System& system, double shift, const SparseMatrix& at_shift)
      : products(2. * shift * shift * system.M + shift * system.C, shift * shift * system.M), T(system, at_shift) {}

  SymmetricPair products;  ///< with s_0 (2 s_0 M + C), and with s_0^2 M
  EffectiveMatrix T;
  std::mutex turn;
};

/// Columns of the slip in its unit: of T(s_0), and of both matrices of the products.
struct SlipColumns {
  Vector of_T;
  Row of_x, of_previous;
};

}  // namespace detail

namespace {

using detail::add_column;
using detail::orthogonalise;
using detail::round_off;

bool is_phi(const System& system, int unknown) {
  return system.field[unknown] == Field::pressure_impulse;
}

/// Squares of the norm's weights, so that all kinds of unknowns count alike: the diagonal of |T|, plus, for each phi,
/// the diagonal of T_pu diag(T_uu)^-1 T_up, as phi has no diagonal entry of its own where the fluid is incompressible
/// and flows with inertia. Where several processes share both phi and u, the squares of their parts of T_pu are summed:
/// another norm, but vectors of it span the same space.
Vector norm_weight(const SparseMatrix& T, const System& system, const Layout& layout) {
  const Vector diagonal = values_of(system, T.diagonal()).cwiseAbs();
  const double least = 1e-12 * layout.largest(diagonal.maxCoeff());
  Vector weight = layout.counted(diagonal);
  for (int i = 0; i < T.rows(); ++i) {
    if (!is_phi(system, i)) continue;
    for (SparseMatrix::InnerIterator entry(T, i); entry; ++entry)
      if (!is_phi(system, static_cast<int>(entry.col())))
        weight[i] += entry.value() * entry.value() / std::max(diagonal[entry.col()], least);
  }
  weight = values_of(system, std::move(weight));
  for (double& w : weight)
    if (!(w > 0.)) w = 1.;  // an unknown without entries
  return weight;
}

}  // namespace

FieldBases detail::empty_bases(const System& system, const SparseMatrix& T) {
  constexpr int room = 128;  // unused columns cost nothing; adding them later takes a copy
  const Layout layout = layout_of(system);
  const Vector weight = norm_weight(T, system, layout);
  FieldBases bases;
  for (int i = 0; i < system.size(); ++i) (is_phi(system, i) ? bases.phi : bases.displacements).unknown.push_back(i);
  for (FieldBasis* basis : {&bases.displacements, &bases.phi}) {
    basis->unit = weight(basis->unknown).cwiseSqrt().cwiseInverse();
    for (std::size_t i = 0; i < basis->unknown.size(); ++i)
      if (basis->unknown[i] >= system.n_free()) basis->unit[i] = 1.;
    basis->vectors.resize(basis->unit.size(), room);
    basis->layout = layout.of(basis->unknown);
  }
  return bases;
}

void detail::keep_unknown(const System& system, int unknown, FieldBases& bases) {
  FieldBasis& basis = is_phi(system, unknown) ? bases.phi : bases.displacements;
  const auto local = std::lower_bound(basis.unknown.begin(), basis.unknown.end(), unknown) - basis.unknown.begin();
  add_column(basis, Vector::Unit(basis.unit.size(), local), static_cast<int>(bases.displacements.n() + bases.phi.n()));
}

FieldBases exact_bases(const System& system, const SparseMatrix& T, const std::vector<int>& exact) {
  FieldBases bases = detail::empty_bases(system, T);
  for (int i = system.n_free(); i < system.size(); ++i) detail::keep_unknown(system, i, bases);
  for (const int i : exact) detail::keep_unknown(system, i, bases);
  return bases;
}

SecondOrderKrylov::SecondOrderKrylov(const System& system, double shift, const std::vector<int>& exact,
                                     const std::vector<Vector>& kept)
    : n_unknowns_(system.size()), shift_(shift) {
  if (!(shift > 0.)) throw std::invalid_argument("the shift of a Krylov space must be positive");
  const SparseMatrix T = shift * shift * system.M + shift * system.C + system.K;
  FieldBases bases = exact_bases(system, T, exact);
  u_ = std::move(bases.displacements);
  phi_ = std::move(bases.phi);
  n_coordinates_ = static_cast<int>(u_.n() + phi_.n());
  for (const Vector& direction : kept) take(direction);
  const Stopwatch watch;
  matrices_ = std::make_shared<detail::KrylovMatrices>(system, shift, T);
  factorise_seconds_ = watch.seconds();
  start(system);
}

SecondOrderKrylov::SecondOrderKrylov(const SecondOrderKrylov& of, const SlipRow& slip)
    : n_unknowns_(of.n_unknowns_),
      shift_(of.shift_),
      matrices_(of.matrices_),
      slip_(std::make_unique<detail::SlipColumns>()),
      n_coordinates_(1) {
  constexpr int room = 64;
  for (const auto& [basis, like] : {std::pair{&u_, &of.u_}, {&phi_, &of.phi_}}) {
    basis->unknown = like->unknown;
    basis->unit = like->unit;
    basis->layout = like->layout;
    basis->vectors.resize(basis->unit.size(), room);
  }
  const double unit = slip.unit_about(shift_);
  slip_->of_T = Vector::Zero(n_unknowns_);
  const auto add = [&](const Row& row, double of_T, double of_x, double of_previous) {
    for (const auto& [i, value] : row) {
      slip_->of_T[i] += of_T * unit * value;
      if (of_x != 0.) slip_->of_x.emplace_back(i, of_x * unit * value);
      if (of_previous != 0.) slip_->of_previous.emplace_back(i, of_previous * unit * value);
    }
  };
  const double square = shift_ * shift_;
  add(slip.M, square, 2. * square, square);
  add(slip.C, shift_, shift_, 0.);
  add(slip.K, 1., 0., 0.);
  start_slip();
}

SecondOrderKrylov::~SecondOrderKrylov() = default;

void SecondOrderKrylov::solve(Vector& rhs, Vector& x) {
  const std::lock_guard<std::mutex> lock(matrices_->turn);
  matrices_->T.solve(rhs, x);
  ++n_solves_;
}

void SecondOrderKrylov::start_slip() {
  Vector rhs = -slip_->of_T, x = Vector::Zero(n_unknowns_);
  solve(rhs, x);
  append(take(x, 1.), Vector());
  n_starts_ = n_vectors_;
}

void SecondOrderKrylov::start(const System& system) {
  const int n = system.size();
  Eigen::MatrixXd directions(n, 0);
  const Layout layout = layout_of(system);
  std::set<int> prescribed;
  for (const SystemLoad& load : system.loads) {
    Vector rhs = Vector::Zero(n), x = Vector::Zero(n);
    if (load.prescribed >= 0) {
      if (!prescribed.insert(load.prescribed).second) continue;
      x[load.prescribed] = 1.;
    } else {
      rhs = load.vector;
      Vector direction = layout.normalised(rhs);  // zero for a load that is zero
      orthogonalise(directions, direction, layout);
      if (layout.norm(direction) < round_off) continue;
      directions.conservativeResize(Eigen::NoChange, directions.cols() + 1);
      directions.rightCols(1) = layout.normalised(direction);
    }
    solve(rhs, x);
    append(take(x), Vector());
  }
  if (n_vectors_ == 0) throw NumericsError("no load acts on the system: there is nothing to reduce");
  n_starts_ = n_vectors_;
}

void SecondOrderKrylov::take(FieldBasis& basis, const Vector& x, double least, Vector& coordinates) {
  Vector y = Vector(x(basis.unknown)).cwiseQuotient(basis.unit);
  const Vector h = orthogonalise(basis.columns(), y, basis.layout);
  for (Eigen::Index j = 0; j < h.size(); ++j) coordinates[basis.coordinate[j]] = h[j];
  const double rest = basis.layout.norm(y);
  if (rest <= least) return;
  add_column(basis, y / rest, n_coordinates_);
  coordinates.conservativeResize(++n_coordinates_);
  coordinates[n_coordinates_ - 1] = rest;
}

Vector SecondOrderKrylov::take(const Vector& x, double slip) {
  double square = slip * slip;
  for (const FieldBasis* basis : {&u_, &phi_})
    square += basis->layout.square(Vector(x(basis->unknown)).cwiseQuotient(basis->unit));
  Vector coordinates = Vector::Zero(n_coordinates_);
  if (slip_) coordinates[0] = slip;
  for (FieldBasis* basis : {&u_, &phi_}) take(*basis, x, round_off * std::sqrt(square), coordinates);
  return coordinates;
}

Vector SecondOrderKrylov::vector_of(const Eigen::Ref<const Vector>& coordinates) const {
  Vector x(n_unknowns_);
  for (const FieldBasis* basis : {&u_, &phi_}) {
    Vector h = Vector::Zero(basis->n());
    for (Eigen::Index j = 0; j < h.size(); ++j)
      if (const int c = basis->coordinate[j]; c < coordinates.size()) h[j] = coordinates[c];
    x(basis->unknown) = Vector(product(basis->columns(), h)).cwiseProduct(basis->unit);
  }
  return x;
}

bool SecondOrderKrylov::append(const Vector& x, const Eigen::Ref<const Vector>& previous) {
  const Eigen::Index R = n_coordinates_;
  Vector pair = Vector::Zero(2 * R);
  pair.head(x.size()) = x;
  pair.segment(R, previous.size()) = previous;
  for (Eigen::MatrixXd* part : {&x_, &previous_}) part->conservativeResizeLike(Eigen::MatrixXd::Zero(R, n_vectors_));
  Eigen::MatrixXd pairs(2 * R, n_vectors_);
  pairs << x_, previous_;
  const double length = pair.norm();
  orthogonalise(pairs, pair);
  if (pair.norm() <= round_off * length) return false;
  pair.normalize();
  ++n_vectors_;
  for (Eigen::MatrixXd* part : {&x_, &previous_}) part->conservativeResize(R, n_vectors_);
  x_.rightCols(1) = pair.head(R);
  previous_.rightCols(1) = pair.tail(R);
  n_directions_.push_back({u_.n(), phi_.n()});
  return true;
}

Vector SecondOrderKrylov::next(const Vector& of_x, const Vector& of_previous) {
  Vector rhs = Vector::Zero(n_unknowns_);
  const Vector x = vector_of(of_x), previous = vector_of(of_previous);
  {
    const std::lock_guard<std::mutex> lock(matrices_->turn);
    matrices_->products.subtract_products(x, previous, rhs);
  }
  if (!slip_) return rhs;
  for (const auto& [i, value] : slip_->of_x) rhs[i] -= value * of_x[0];
  for (const auto& [i, value] : slip_->of_previous) rhs[i] -= value * of_previous[0];
  return rhs;
}

bool SecondOrderKrylov::extend() {
  Vector x(n_unknowns_);
  while (n_expanded_ < n_vectors_) {
    check_interrupt();
    const Vector of_x = x_.col(n_expanded_), of_previous = previous_.col(n_expanded_);
    ++n_expanded_;
    Vector rhs = next(of_x, of_previous);
    x.setZero();
    solve(rhs, x);
    if (append(take(x), of_x)) return true;
  }
  return false;
}

namespace {

/// Y without its part in the span of the columns of V, twice; returns the coordinates of that part. The basis is larger
/// than any cache: by blocks of rows, what the second time needs is found while the first time takes away.
Eigen::MatrixXd leave_outside(const Eigen::Ref<const Eigen::MatrixXd>& V, Eigen::MatrixXd& Y) {
  constexpr Eigen::Index largest_block = 512;
  const Eigen::MatrixXd first = transposed_product(V, Y);
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(first.rows(), first.cols());
  for (Eigen::Index r = 0; r < Y.rows(); r += largest_block) {
    const Eigen::Index n = std::min(largest_block, Y.rows() - r);
    Y.middleRows(r, n) -= product(V.middleRows(r, n), first);
    second += transposed_product(V.middleRows(r, n), Y.middleRows(r, n));
  }
  Y -= product(V, second);
  return first + second;
}

}  // namespace

/// Enlarges the coordinates by those of directions that are new.
void SecondOrderKrylov::take_together(FieldBasis& basis, const Eigen::MatrixXd& x, Eigen::MatrixXd& coordinates) {
  Eigen::MatrixXd Y = basis.unit.cwiseInverse().asDiagonal() * x(basis.unknown, Eigen::all);
  const Eigen::MatrixXd H = leave_outside(basis.columns(), Y);
  for (Eigen::Index j = 0; j < H.rows(); ++j) coordinates.row(basis.coordinate[j]) += H.row(j);
  const Eigen::Index first = basis.n();
  for (Eigen::Index c = 0; c < Y.cols(); ++c) {
    Vector y = Y.col(c);
    if (basis.n() > first) {
      const Vector h = orthogonalise(basis.columns_from(first), y);
      for (Eigen::Index j = 0; j < h.size(); ++j) coordinates(basis.coordinate[first + j], c) += h[j];
    }
    const double rest = y.norm();
    if (rest <= round_off * (rest + coordinates.col(c).norm())) continue;
    add_column(basis, y / rest, n_coordinates_);
    coordinates.conservativeResizeLike(Eigen::MatrixXd::Zero(++n_coordinates_, Y.cols()));
    coordinates(n_coordinates_ - 1, c) = rest;
  }
}

bool SecondOrderKrylov::extend_together() {
  check_interrupt();
  const Eigen::Index m = std::min(n_starts_, n_vectors_ - n_expanded_), first = n_expanded_;
  if (m == 0) return false;
  const Eigen::MatrixXd of_x = x_.middleCols(first, m);
  Eigen::MatrixXd of_both(x_.rows(), 2 * m);
  of_both << of_x, previous_.middleCols(first, m);
  n_expanded_ += static_cast<int>(m);
  const auto vectors_of = [&](const Eigen::MatrixXd& coordinates) {
    Eigen::MatrixXd x(n_unknowns_, coordinates.cols());
    for (const FieldBasis* basis : {&u_, &phi_}) {
      Eigen::MatrixXd h = Eigen::MatrixXd::Zero(basis->n(), coordinates.cols());
      for (Eigen::Index j = 0; j < h.rows(); ++j)
        if (const int c = basis->coordinate[j]; c < coordinates.rows()) h.row(j) = coordinates.row(c);
      x(basis->unknown, Eigen::all) = basis->unit.asDiagonal() * product(basis->columns(), h);
    }
    return x;
  };
  const Eigen::MatrixXd x = vectors_of(of_both);  // the previous ones behind them
  Eigen::MatrixXd next = Eigen::MatrixXd::Zero(n_unknowns_, m);
  {
    const std::lock_guard<std::mutex> lock(matrices_->turn);
    for (Eigen::Index c = 0; c < m; ++c) {
      Vector rhs = Vector::Zero(n_unknowns_);
      matrices_->products.subtract_products(x.col(c), x.col(m + c), rhs);
      next.col(c) = rhs;
    }
    const Eigen::Index n_free = matrices_->T.n_free();
    next.topRows(n_free) = matrices_->T.solve_columns(next.topRows(n_free));
    next.bottomRows(n_unknowns_ - n_free).setZero();
  }
  n_solves_ += static_cast<int>(m);
  Eigen::MatrixXd coordinates = Eigen::MatrixXd::Zero(n_coordinates_, m);
  for (FieldBasis* basis : {&u_, &phi_}) take_together(*basis, next, coordinates);
  bool added = false;
  for (Eigen::Index c = 0; c < m; ++c) added = append(coordinates.col(c), of_x.col(c)) || added;
  return added || extend_together();
}

}  // namespace upbead
