#include "dynamics/interface_space.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

#include "algebra/dense.h"
#include "dynamics/orthogonalise.h"
#include "dynamics/products.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using detail::VectorBlock;

constexpr double fast_share = 4.;  ///< the second shift, over the first: about a stage of contact's steps
/// Moments at each level, about the first and the second shift: of loads, and of motions of rising degree, of which
/// higher ones begin at a higher level, so that the difference of two levels tells what is missed without them.
constexpr int slow_loads[] = {24, 40, 60}, fast_loads[] = {10, 16, 24};
constexpr int slow_motions[][3] = {{8, 12, 16}, {0, 6, 12}, {0, 0, 6}},
              fast_motions[][3] = {{3, 5, 8}, {0, 3, 6}, {0, 0, 3}};
/// Degrees of each of these: as many as carry nothing, then so many more.
constexpr Eigen::Index more_degrees = 4;

/// Directions count above this part of a start's length.
constexpr double least_length[] = {1e-4, 1e-4, 1e-5};

SparseMatrix at_shift(const System& system, double shift) {
  return shift * shift * system.M + shift * system.C + system.K;
}

/// Bases of `exact` unknowns alone.
FieldBases bases_of(const System& system, const SparseMatrix& T, const std::vector<int>& exact) {
  FieldBases bases = detail::empty_bases(system, T);
  for (const int i : exact) detail::keep_unknown(system, i, bases);
  return bases;
}

/// Unknowns that are coordinates themselves.
std::vector<bool> own_unknowns(const System& system, const std::vector<int>& exact) {
  std::vector<bool> own(static_cast<std::size_t>(system.size()), false);
  for (int i = system.n_free(); i < system.size(); ++i) own[static_cast<std::size_t>(i)] = true;
  for (const int i : exact) own[static_cast<std::size_t>(i)] = true;
  return own;
}

}  // namespace

MomentTrain::MomentTrain(const System& system, double shift)
    : system_(system),
      shift_(shift),
      n_free_(system.n_free()),
      T_(at_shift(system, shift)),
      factors_(SparseMatrix(T_.topLeftCorner(n_free_, n_free_)), system.blocks, system.sharing) {}

MomentTrain::~MomentTrain() = default;

Eigen::MatrixXd MomentTrain::solved(const Eigen::MatrixXd& rhs) {
  n_solves_ += static_cast<int>(rhs.cols());
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(T_.rows(), rhs.cols());
  x.topRows(n_free_) = factors_.solve_columns(rhs.topRows(n_free_));
  return x;
}

Eigen::MatrixXd MomentTrain::follow(const Eigen::MatrixXd& motions) {
  const Eigen::Index n = motions.rows();
  const SparseMatrix coupling = SparseMatrix(T_.topRows(n_free_)).rightCols(n);
  Eigen::MatrixXd x = solved(-(coupling * VectorBlock(motions)));
  x.bottomRows(n) = motions;
  return x;
}

Eigen::MatrixXd MomentTrain::answer(const Eigen::MatrixXd& loads) {
  return solved(loads);
}

Eigen::MatrixXd MomentTrain::next(const Eigen::MatrixXd& now, Eigen::MatrixXd& mass_before) {
  const VectorBlock moments = now;
  Eigen::MatrixXd mass = detail::block_product(system_.M, moments);
  Eigen::MatrixXd rhs = -2. * shift_ * shift_ * mass - shift_ * detail::block_product(system_.C, moments);
  if (mass_before.size() > 0) rhs -= shift_ * shift_ * mass_before;
  mass_before = std::move(mass);
  return solved(rhs);
}

InterfaceSpace::InterfaceSpace(const System& system, double shift, const std::vector<int>& exact,
                               const std::vector<Vector>& kept, Eigen::MatrixXd of_loads)
    : system_(system),
      shift_(shift),
      own_(own_unknowns(system, exact)),
      of_loads_(std::move(of_loads)),
      slow_(system, shift),
      bases_(bases_of(system, slow_.matrix(), exact)),
      n_own_{bases_.displacements.n(), bases_.phi.n()},
      fast_(system, fast_share * shift),
      carried_(system, fast_.matrix(), own_) {
  if (!kept.empty()) {
    Eigen::MatrixXd columns(system.size(), static_cast<Eigen::Index>(kept.size()));
    for (std::size_t k = 0; k < kept.size(); ++k) columns.col(static_cast<Eigen::Index>(k)) = kept[k];
    add(bases_.displacements, {columns});
  }
  n_exact_ = bases_.displacements.n();
  start();
  extend();
}

InterfaceSpace::~InterfaceSpace() = default;

int InterfaceSpace::n_solves() const {
  return slow_.n_solves() + fast_.n_solves();
}

void InterfaceSpace::start() {
  std::vector<const Vector*> acting;
  for (const SystemLoad& load : system_.loads)
    if (of_loads_.size() == 0 && load.vector.head(system_.n_free()).squaredNorm() > 0.) acting.push_back(&load.vector);
  Eigen::MatrixXd loads(system_.size(), static_cast<Eigen::Index>(acting.size()));
  for (std::size_t k = 0; k < acting.size(); ++k) loads.col(static_cast<Eigen::Index>(k)) = *acting[k];
  const auto add_series = [&](MomentTrain& train, const int* orders, const Eigen::MatrixXd& start, bool of_loads) {
    if (start.cols() > 0) series_.push_back({&train, orders, of_loads, start, {}, {}, 0});
  };
  add_series(slow_, slow_loads, loads, true);
  add_series(fast_, fast_loads, loads, true);
  Eigen::Index first = 0;
  for (std::size_t group = 0; group < std::size(slow_motions); ++group) {
    const Eigen::MatrixXd& motions = carried_.by_degree();
    const Eigen::Index wanted = group == 0 ? 2 * CarriedMotions::low_degrees : 2 * more_degrees;
    const Eigen::Index n = std::min(wanted, motions.cols() - first);
    add_series(slow_, slow_motions[group], motions.middleCols(first, n), false);
    add_series(fast_, fast_motions[group], motions.middleCols(first, n), false);
    first += n;
  }
}

/// All starts get the length 1 in the norm of the bases, without the coordinates that are kept anyhow.
Eigen::MatrixXd InterfaceSpace::normalised(Eigen::MatrixXd first) const {
  for (Eigen::Index j = 0; j < first.cols(); ++j) {
    double square = 0.;
    for (const FieldBasis* basis : {&bases_.displacements, &bases_.phi})
      for (std::size_t i = 0; i < basis->unknown.size(); ++i)
        if (const int unknown = basis->unknown[i]; !own_[static_cast<std::size_t>(unknown)]) {
          const double value = first(unknown, j) / basis->unit[static_cast<Eigen::Index>(i)];
          square += value * value;
        }
    if (square > 0.) first.col(j) /= std::sqrt(square);
  }
  return first;
}

/// The first two thirds belong to the first level, so that the next one tells what they miss.
Eigen::MatrixXd InterfaceSpace::loads_of_level() const {
  const Eigen::Index all = of_loads_.cols(), first = level_ == 0 ? 0 : 2 * all / 3;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(system_.size(), level_ == 0 ? 2 * all / 3 : all - first);
  columns.topRows(of_loads_.rows()) = of_loads_.middleCols(first, columns.cols());
  return columns;
}

void InterfaceSpace::take_level() {
  std::vector<Eigen::MatrixXd> columns;
  if (of_loads_.size() > 0 && level_ < 2) columns.push_back(loads_of_level());
  for (MomentSeries& series : series_)
    for (; series.done < series.orders[level_]; ++series.done) {
      series.now = series.done > 0   ? series.train->next(series.now, series.mass_before)
                   : series.of_loads ? normalised(series.train->answer(series.start))
                                     : normalised(series.train->follow(series.start));
      columns.push_back(series.now);
    }
  add(bases_.displacements, columns);
  add(bases_.phi, columns);
}

/// Adds the directions of the columns that are new and count.
void InterfaceSpace::add(FieldBasis& basis, const std::vector<Eigen::MatrixXd>& columns) {
  if (basis.unknown.empty()) return;
  const bool is_phi = &basis == &bases_.phi;
  const Eigen::Index n_own = n_own_[is_phi ? 1 : 0], n_old = basis.n() - n_own;
  Eigen::Index n = 0, next = 0;
  for (const Eigen::MatrixXd& block : columns) n += block.cols();
  Eigen::MatrixXd Y(static_cast<Eigen::Index>(basis.unknown.size()), n);
  for (const Eigen::MatrixXd& block : columns) {
    Y.middleCols(next, block.cols()) = basis.unit.cwiseInverse().asDiagonal() * block(basis.unknown, Eigen::all);
    next += block.cols();
  }
  for (std::size_t i = 0; i < basis.unknown.size(); ++i)
    if (own_[static_cast<std::size_t>(basis.unknown[i])]) Y.row(static_cast<Eigen::Index>(i)).setZero();
  const auto old = basis.vectors.middleCols(n_own, n_old);
  const auto without_old = [&](Eigen::MatrixXd& of) {
    if (n_old > 0) of -= product(old, transposed_product(old, of));
  };
  without_old(Y);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(transposed_product(Y, Y));  // ascending
  const double least = level_ < 0 ? detail::round_off : least_length[level_];
  const Eigen::Index m = (modes.eigenvalues().array() > least * least).count();
  if (m == 0) return;
  Eigen::MatrixXd V = product(Y, modes.eigenvectors().rightCols(m));
  V *= modes.eigenvalues().tail(m).cwiseSqrt().cwiseInverse().asDiagonal();
  without_old(V);  // again, as what round-off leaves of a long column is much beside a short one
  for (int pass = level_ < 0 ? 0 : 1; pass < 2; ++pass) {  // orthonormal to round-off by Cholesky's factor
    const Eigen::LLT<Eigen::MatrixXd> factor(transposed_product(V, V));
    V = product(V, factor.matrixL().solve(Eigen::MatrixXd::Identity(m, m)).transpose());
  }
  for (Eigen::Index j = m - 1; j >= 0; --j)
    detail::add_column(basis, V.col(j), static_cast<int>(bases_.displacements.n() + bases_.phi.n()));
}

void InterfaceSpace::extend() {
  ++level_;
  take_level();
  const Eigen::Index first_u = projection_ ? n_projected_[0] : 0, first_phi = projection_ ? n_projected_[1] : 0;
  if (projection_)
    projection_->extend();
  else
    projection_ = std::make_unique<Projection>(system_, bases_.displacements, bases_.phi, shift_);
  const Eigen::Index r = projection_->reduced().size(), m = system_.n_prescribed;
  for (Eigen::MatrixXd* A : {&coupling_.M, &coupling_.C, &coupling_.K}) A->conservativeResize(r, m);
  for (const auto& [basis, first] : {std::pair{&bases_.displacements, first_u}, {&bases_.phi, first_phi}}) {
    const OfMatrices added = carried_.with(*basis, first);
    for (Eigen::Index j = first; j < basis->n(); ++j) {
      const int row = basis->coordinate[static_cast<std::size_t>(j)];
      coupling_.M.row(row) = added.M.row(j - first);
      coupling_.C.row(row) = added.C.row(j - first);
      coupling_.K.row(row) = added.K.row(j - first);
    }
  }
  n_projected_[0] = bases_.displacements.n();
  n_projected_[1] = bases_.phi.n();
}

namespace {

/// Coordinates in which K is diagonal, those of displacements first.
struct Coordinates {
  Eigen::MatrixXd Z;
  Eigen::Index n_displacements, n_diagonal;  ///< the first of these have a diagonal M
};

/// Orthonormal coordinates of both kinds apart in which K is diagonal; of displacements such that M is diagonal, too,
/// and s^2 M + K = 1, unless that is nearly singular.
Coordinates with_diagonal(const ReducedSystem& reduced) {
  constexpr double least = 1e-8;
  Coordinates out{Eigen::MatrixXd::Zero(reduced.size(), reduced.size()), 0, 0};
  Eigen::Index first = 0;
  for (const bool is_phi : {false, true}) {
    std::vector<int> list;
    for (int i = 0; i < reduced.size(); ++i)
      if (reduced.is_phi[static_cast<std::size_t>(i)] == is_phi) list.push_back(i);
    if (list.empty()) continue;
    const auto n = static_cast<Eigen::Index>(list.size());
    Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n), K = reduced.K(list, list);
    if (!is_phi) {
      out.n_displacements = n;
      const Eigen::MatrixXd M = reduced.M(list, list);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> whole(reduced.shift * reduced.shift * M + K);
      if (whole.eigenvalues()[0] > least * whole.eigenvalues()[n - 1]) {
        unit = whole.eigenvectors() * whole.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
        K = transposed_product(unit, product(K, unit));
        out.n_diagonal = n;
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(K);
    out.Z(list, Eigen::seqN(first, n)) = product(unit, modes.eigenvectors());
    first += n;
  }
  return out;
}

}  // namespace

/// Motions of the nodes whose couplings are kept to round-off: smooth ones, which carry nothing, and all that moves
/// with the bodies.
Eigen::MatrixXd InterfaceSpace::exact_motions() const {
  const Eigen::MatrixXd& degrees = carried_.by_degree();
  const Eigen::Index n_low = std::min(2 * CarriedMotions::low_degrees, degrees.cols());
  Eigen::MatrixXd motions(degrees.rows(), n_low + 3 * (n_exact_ + n_own_[1]));
  motions.leftCols(n_low) = degrees.leftCols(n_low);
  Eigen::Index next = n_low;
  for (const auto& [basis, n] : {std::pair{&bases_.displacements, n_exact_}, {&bases_.phi, n_own_[1]}})
    for (Eigen::Index j = 0; j < n; ++j)
      for (const Eigen::MatrixXd* A : {&coupling_.M, &coupling_.C, &coupling_.K})
        motions.col(next++) = A->row(basis->coordinate[static_cast<std::size_t>(j)]).stableNormalized();
  return motions;
}

InterfaceModel InterfaceSpace::model() const {
  const ReducedSystem& reduced = projection_->reduced();
  const Coordinates coordinates = with_diagonal(reduced);
  const Eigen::MatrixXd& Z = coordinates.Z;
  const Eigen::Index r = reduced.size(), m = system_.n_prescribed;
  const auto turned = [&](const OfMatrices& A, bool twice) -> OfMatrices {
    const auto turn = [&](const Eigen::MatrixXd& one) { return transposed_product(Z, twice ? product(one, Z) : one); };
    return {turn(A.M), turn(A.C), turn(A.K)};
  };
  const auto rows = [&](const Eigen::MatrixXd& of_free, Row Reading::*part) {
    Eigen::MatrixXd all(of_free.rows(), r + m);
    all << product(of_free, Z), carried_.read(system_.readings, part);
    return all;
  };
  InterfaceModel model{{},
                       {turned({reduced.M, reduced.C, reduced.K}, true), turned(coupling_, false), carried_.matrices(),
                        exact_motions(), coordinates.n_diagonal, fast_share * shift_},
                       rows(reduced.position, &Reading::position),
                       rows(reduced.velocity, &Reading::velocity),
                       rows(reduced.acceleration, &Reading::acceleration),
                       reduced.feedthrough,
                       bases_.displacements,
                       bases_.displacements.n(),
                       {bases_.phi.unknown, bases_.phi.unit, bases_.phi.columns(), bases_.phi.coordinate},
                       carried_,
                       Z};
  System& system = model.system;
  system.M = system.C = system.K = SparseMatrix(r + m, r + m);
  system.field.assign(static_cast<std::size_t>(r + m), Field::displacement);
  std::fill(system.field.begin() + coordinates.n_displacements, system.field.begin() + r, Field::pressure_impulse);
  system.loads = system_.loads;
  for (std::size_t k = 0; k < system.loads.size(); ++k) {
    Vector along(r + m);
    along << transposed_product(Z, reduced.load.col(static_cast<Eigen::Index>(k))),
        carried_.along(system_.loads[k].vector);
    system.loads[k].vector = along;
  }
  system.n_prescribed = system_.n_prescribed;
  system.interface = system_.interface;
  system.frame_damping = system_.frame_damping;
  system.frame_radiation = system_.frame_radiation;
  return model;
}

void Motions::see(const State& state, int step, int) {
  if (step == 0) *this = {};
  n_ = state.x.size();
  x_.insert(x_.end(), state.x.begin(), state.x.end());
  v_.insert(v_.end(), state.v.begin(), state.v.end());
  a_.insert(a_.end(), state.a.begin(), state.a.end());
}

Eigen::Map<const Eigen::MatrixXd> Motions::columns(const std::vector<double>& values) const {
  return {values.data(), n_, static_cast<Eigen::Index>(values.size()) / std::max<Eigen::Index>(n_, 1)};
}

/// The steps of contact satisfy the equation of motion at their ends.
Response InterfaceModel::read(Response response, const Motions& motions) const {
  Series& ends = response.ends;
  ends.reading = product(position, motions.x()) + product(velocity, motions.v()) + product(acceleration, motions.a());
  if (feedthrough.cols() > 0) ends.reading += product(feedthrough, ends.load);
  response.balanced = ends;
  response.inside.reading.resize(position.rows(), 0);
  return response;
}

Eigen::MatrixXd InterfaceModel::pressures(const Motions& motions) const {
  return product(to_bases(phi.coordinate, Eigen::all), motions.v().topRows(to_bases.cols()));
}

State InterfaceModel::whole(const State& state) const {
  const auto n = static_cast<Eigen::Index>(displacements.unknown.size() + phi.unknown.size());
  const auto lifted = [&](const Vector& from) -> Vector {
    Vector to = Vector::Zero(n);
    const Vector q = product(to_bases, from.head(to_bases.cols()));
    for (const auto& [basis, m] : {std::pair{&displacements, n_displacements}, {&phi, phi.n()}}) {
      if (basis->unknown.empty()) continue;
      const std::vector<int> own(basis->coordinate.begin(), basis->coordinate.begin() + m);
      to(basis->unknown) = Vector(product(basis->vectors.leftCols(m), q(own).eval())).cwiseProduct(basis->unit);
    }
    carried.add_to(from.tail(from.size() - to_bases.cols()), to);
    return to;
  };
  return {state.time, lifted(state.x), lifted(state.v), lifted(state.a)};
}

}  // namespace upbead
