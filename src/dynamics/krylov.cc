#include "upbead/dynamics/krylov.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "effective_matrix.h"
#include "orthogonalise.h"
#include "products.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

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

FieldBases exact_bases(const System& system, const SparseMatrix& T, const std::vector<int>& exact) {
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
  int n_coordinates = 0;
  const auto keep = [&](int unknown) {
    FieldBasis& basis = is_phi(system, unknown) ? bases.phi : bases.displacements;
    const auto local = std::lower_bound(basis.unknown.begin(), basis.unknown.end(), unknown) - basis.unknown.begin();
    add_column(basis, Vector::Unit(basis.unit.size(), local), n_coordinates++);
  };
  for (int i = system.n_free(); i < system.size(); ++i) keep(i);
  for (const int i : exact) keep(i);
  return bases;
}

SecondOrderKrylov::SecondOrderKrylov(const System& system, double shift, const std::vector<int>& exact,
                                     const std::vector<Vector>& kept)
    : n_unknowns_(system.size()), shift_(shift) {
  if (!(shift > 0.)) throw std::invalid_argument("the shift of a Krylov space must be positive");
  products_ = std::make_unique<detail::SymmetricPair>(2. * shift * shift * system.M + shift * system.C,
                                                      shift * shift * system.M);
  const SparseMatrix T = shift * shift * system.M + shift * system.C + system.K;
  FieldBases bases = exact_bases(system, T, exact);
  u_ = std::move(bases.displacements);
  phi_ = std::move(bases.phi);
  n_coordinates_ = static_cast<int>(u_.n() + phi_.n());
  for (const Vector& direction : kept) take(direction);
  const Stopwatch watch;
  T_ = std::make_unique<detail::EffectiveMatrix>(system, T);
  factorise_seconds_ = watch.seconds();
  start(system);
}

SecondOrderKrylov::~SecondOrderKrylov() = default;

void SecondOrderKrylov::solve(Vector& rhs, Vector& x) {
  T_->solve(rhs, x);
  ++n_solves_;
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

Vector SecondOrderKrylov::take(const Vector& x) {
  double square = 0.;
  for (const FieldBasis* basis : {&u_, &phi_})
    square += basis->layout.square(Vector(x(basis->unknown)).cwiseQuotient(basis->unit));
  Vector coordinates = Vector::Zero(n_coordinates_);
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
  return true;
}

bool SecondOrderKrylov::extend() {
  Vector x(n_unknowns_);
  while (n_expanded_ < n_vectors_) {
    check_interrupt();
    const Vector of_x = x_.col(n_expanded_), of_previous = previous_.col(n_expanded_);
    ++n_expanded_;
    Vector rhs = Vector::Zero(n_unknowns_);
    products_->subtract_products(vector_of(of_x), vector_of(of_previous), rhs);
    x.setZero();
    solve(rhs, x);
    if (append(take(x), of_x)) return true;
  }
  return false;
}

}  // namespace upbead
