#include "dynamics/slip_basis.h"

#include <algorithm>

#include "algebra/dense.h"
#include "dynamics/orthogonalise.h"
#include "dynamics/slip_model.h"

namespace upbead {

namespace {

/// The fewest vectors of each start from one look to the next, as in basis.cc.
constexpr int vectors_of_each = 6;

/// Vectors of that many starts at a look.
int vectors_at(std::size_t number, int n_starts) {
  int n = ReduceOptions().first_vectors * n_starts;
  for (std::size_t i = 0; i < number; ++i) n += std::max(vectors_of_each * n_starts, n / 4);
  return n;
}

/// Vectors of each of them, rounded up: no look has fewer than the space of all starts together would have.
int vectors_of_each_at(std::size_t number, int n_starts) {
  return (vectors_at(number, n_starts) + n_starts - 1) / n_starts;
}

/// The first directions, with room for more.
FieldBasis begun(const FieldBasis& basis, Eigen::Index n) {
  FieldBasis out{basis.unknown, basis.unit, {}, {basis.coordinate.begin(), basis.coordinate.begin() + n}, basis.layout};
  out.vectors.resize(basis.vectors.rows(), std::max<Eigen::Index>(96, 2 * n));
  out.vectors.leftCols(n) = basis.vectors.leftCols(n);
  return out;
}

/// Adds what the columns, of length 1, have outside the span of a basis.
void add_directions(FieldBasis& basis, const Eigen::Ref<const Eigen::MatrixXd>& columns, int& n_coordinates) {
  if (columns.cols() == 0) return;
  Eigen::MatrixXd rest = columns;
  for (int pass = 0; pass < 2; ++pass)  // as once is not enough near the span
    rest -= product(basis.columns(), transposed_product(basis.columns(), rest));
  const Eigen::Index first = basis.n();
  for (Eigen::Index c = 0; c < rest.cols(); ++c) {
    Vector y = rest.col(c);
    if (basis.n() > first) detail::orthogonalise(basis.columns_from(first), y);
    const double length = y.norm();
    if (length > detail::round_off) detail::add_column(basis, y / length, n_coordinates++);
  }
}

/// The principal block of the first coordinates.
ReducedSystem leading_block(ReducedSystem system, Eigen::Index n) {
  for (Eigen::MatrixXd* A : {&system.M, &system.C, &system.K}) A->conservativeResize(n, n);
  for (Eigen::MatrixXd* rows : {&system.position, &system.velocity, &system.acceleration})
    rows->conservativeResize(Eigen::NoChange, n);
  system.load.conservativeResize(n, Eigen::NoChange);
  system.is_phi.resize(static_cast<std::size_t>(n));
  return system;
}

/// A row of unknowns, in coordinates.
Eigen::RowVectorXd in_coordinates(const Row& row, const FieldBasis& u, const FieldBasis& phi) {
  Eigen::RowVectorXd out = Eigen::RowVectorXd::Zero(u.n() + phi.n());
  for (const FieldBasis* basis : {&u, &phi})
    for (const auto& [unknown, value] : row) {
      const auto found = std::lower_bound(basis->unknown.begin(), basis->unknown.end(), unknown);
      if (found == basis->unknown.end() || *found != unknown) continue;
      const Eigen::Index at = found - basis->unknown.begin();
      for (Eigen::Index c = 0; c < basis->n(); ++c)
        out[basis->coordinate[static_cast<std::size_t>(c)]] += value * basis->unit[at] * basis->vectors(at, c);
    }
  return out;
}

/// Enlarges with a row and a column: `row`, `own` on the diagonal.
void border(Eigen::MatrixXd& A, const Eigen::RowVectorXd& row, double own) {
  const Eigen::Index n = A.rows();
  A.conservativeResize(n + 1, n + 1);
  A.row(n).head(n) = row;
  A.col(n).head(n) = row.transpose();
  A(n, n) = own;
}

/// Enlarges readings with a column, then with two rows of s and s'.
void add_slip_column(Eigen::MatrixXd& rows, const std::vector<double>& column, double of_s, double of_velocity) {
  const Eigen::Index I = rows.rows(), n = rows.cols();
  rows.conservativeResizeLike(Eigen::MatrixXd::Zero(I + 2, n + 1));
  for (std::size_t i = 0; i < column.size(); ++i) rows(static_cast<Eigen::Index>(i), n) = column[i];
  rows(I, n) = of_s;
  rows(I + 1, n) = of_velocity;
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace

SlipBasis::SlipBasis(std::shared_ptr<GrowingBasis> bonded, SlipRow row)
    : bonded_(std::move(bonded)), row_(std::move(row)), own_(bonded_->krylov(), row_) {}

void SlipBasis::grow_own(int n_vectors, const std::function<void(int)>& progress) {
  while (own_.n_vectors() < n_vectors && !exhausted_) {
    exhausted_ = !own_.extend();
    if (progress) progress(own_.n_vectors());
  }
}

void SlipBasis::prepare() {
  grow_own(vectors_of_each_at(0, n_independent_loads()), {});
}

void SlipBasis::take_bonded(const Look& of_bonded, int n_vectors) {
  const SecondOrderKrylov& space = bonded_->krylov();
  const std::array<Eigen::Index, 2> n = space.n_directions(std::min(n_vectors, of_bonded.n_vectors));
  if (!projection_) {
    u_ = begun(space.displacements(), n[0]);
    phi_ = begun(space.phi(), n[1]);
    n_coordinates_ = static_cast<int>(n[0] + n[1]);
    projection_.emplace(bonded_->projection(), leading_block(of_bonded.system, n[0] + n[1]), u_, phi_);
  } else {
    const auto more = [](const FieldBasis& basis, Eigen::Index from, Eigen::Index to) {
      return basis.vectors.middleCols(from, to - from);
    };
    add_directions(u_, more(space.displacements(), of_bonded_[0], n[0]), n_coordinates_);
    add_directions(phi_, more(space.phi(), of_bonded_[1], n[1]), n_coordinates_);
  }
  of_bonded_ = n;
}

void SlipBasis::take_own() {
  const FieldBasis &u = own_.displacements(), &phi = own_.phi();
  add_directions(u_, u.columns_from(of_own_[0]), n_coordinates_);
  add_directions(phi_, phi.columns_from(of_own_[1]), n_coordinates_);
  of_own_ = {u.n(), phi.n()};
}

ReducedSystem SlipBasis::with_slip() const {
  ReducedSystem out = projection_->reduced();
  const double unit = row_.unit_about(out.shift), s = unit * row_.unit;
  border(out.M, unit * in_coordinates(row_.M, u_, phi_), unit * unit * row_.m);
  border(out.C, unit * in_coordinates(row_.C, u_, phi_), unit * unit * row_.c);
  border(out.K, unit * in_coordinates(row_.K, u_, phi_), unit * unit * row_.k);
  const Eigen::Index K = out.load.cols(), R = out.load.rows();
  out.load.conservativeResizeLike(Eigen::MatrixXd::Zero(R + 1, K + 1));
  for (std::size_t k = 0; k < row_.load.size(); ++k) out.load(R, static_cast<Eigen::Index>(k)) = unit * row_.load[k];
  out.load(R, K) = -s;
  add_slip_column(out.position, times(row_.position, unit), s, 0.);
  add_slip_column(out.velocity, times(row_.velocity, unit), 0., s);
  add_slip_column(out.acceleration, times(row_.acceleration, unit), 0., 0.);
  out.feedthrough.conservativeResizeLike(Eigen::MatrixXd::Zero(out.feedthrough.rows() + 2, K + 1));
  System names;
  names.field = {Field::displacement};
  add_slip(names, 0);
  out.prescribed.push_back(-1);
  out.is_phi.push_back(false);
  out.load_name.push_back(names.loads.front().name);
  for (const Reading& reading : names.readings)
    out.reading_label.push_back({reading.name.text(), reading.unit, reading.description});
  return out;
}

Look SlipBasis::next_look(const std::function<void(int)>& progress) {
  const int n = vectors_of_each_at(looks_.size(), n_independent_loads());
  const int of_loads = n * bonded_->n_independent_loads();
  const Look& of_bonded = bonded_->reach(of_loads, progress);
  grow_own(n, [&](int n_own) {
    if (progress) progress(of_loads + n_own);
  });
  take_bonded(of_bonded, of_loads);
  take_own();
  projection_->extend();
  Look look;
  look.n_vectors = std::min(of_loads, of_bonded.n_vectors) + own_.n_vectors();
  look.n_solves = std::min(of_loads, of_bonded.n_solves) + own_.n_solves();
  look.exhausted = exhausted_ && of_bonded.n_vectors <= of_loads && of_bonded.exhausted;
  look.next = vectors_at(looks_.size() + 1, n_independent_loads());
  look.n_displacements = u_.n();
  look.n_phi = phi_.n();
  look.system = with_slip();
  return look;
}

const Look& SlipBasis::look(std::size_t number, const std::function<void(int)>& progress) {
  while (looks_.size() <= number) looks_.push_back(next_look(progress));
  return looks_[number];
}

}  // namespace upbead
