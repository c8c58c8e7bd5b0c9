#include "dynamics/interface_space.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <utility>

#include "algebra/dense.h"
#include "dynamics/orthogonalise.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Row by row, so that a sparse matrix is read once for all columns.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double fast_share = 4.;  ///< the second shift, over the first: about a stage of contact's steps
constexpr Eigen::Index low_degrees = 6;
/// Moments at each level, about the first and the second shift.
constexpr int slow_motions[] = {7, 11, 16}, fast_motions[] = {3, 5, 8}, slow_loads[] = {24, 40, 60},
              fast_loads[] = {10, 16, 24};
/// Directions count above this part of a start's length.
constexpr double least_length[] = {1e-4, 1e-4, 1e-5};

SparseMatrix at_shift(const System& system, double shift) {
  return shift * shift * system.M + shift * system.C + system.K;
}

/// Orthonormal functions of the nodes: polynomials of rising degree as far as these are independent.
Eigen::MatrixXd by_degree(const std::vector<double>& position) {
  const auto n = static_cast<Eigen::Index>(position.size());
  const double first = position.front(), length = std::max(position.back() - first, 1e-300);
  Eigen::MatrixXd values(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = 2. * (position[static_cast<std::size_t>(i)] - first) / length - 1.;
    double now = 1., next = x;  // Chebyshev's, by their recurrence
    for (Eigen::Index k = 0; k < n; ++k) {
      values(i, k) = now;
      now = std::exchange(next, 2. * x * next - now);
    }
  }
  return values.householderQr().householderQ();
}

}  // namespace

MomentTrain::MomentTrain(const System& system, double shift)
    : n_free_(system.n_free()),
      T_(at_shift(system, shift)),
      with_now_(2. * shift * shift * system.M + shift * system.C),
      with_before_(shift * shift * system.M),
      factors_(SparseMatrix(T_.topLeftCorner(n_free_, n_free_)), system.blocks, system.sharing) {}

MomentTrain::~MomentTrain() = default;
MomentTrain::MomentTrain(MomentTrain&&) noexcept = default;

Eigen::MatrixXd MomentTrain::solved(const Eigen::MatrixXd& rhs) {
  n_solves_ += static_cast<int>(rhs.cols());
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(T_.rows(), rhs.cols());
  x.topRows(n_free_) = factors_.solve_columns(rhs.topRows(n_free_));
  return x;
}

Eigen::MatrixXd MomentTrain::follow(const Eigen::MatrixXd& motions) {
  const Eigen::Index n = motions.rows();
  const SparseMatrix coupling = SparseMatrix(T_.topRows(n_free_)).rightCols(n);
  Eigen::MatrixXd x = solved(-(coupling * Rows(motions)));
  x.bottomRows(n) = motions;
  return x;
}

Eigen::MatrixXd MomentTrain::answer(const Eigen::MatrixXd& loads) {
  return solved(loads);
}

Eigen::MatrixXd MomentTrain::next(const Eigen::MatrixXd& now, const Eigen::MatrixXd& before) {
  Rows rhs = -(with_now_ * Rows(now));
  if (before.size() > 0) rhs -= with_before_ * Rows(before);
  return solved(rhs);
}

InterfaceSpace::InterfaceSpace(const System& system, double shift, const std::vector<int>& exact,
                               const std::vector<Vector>& kept)
    : system_(system),
      shift_(shift),
      own_(static_cast<std::size_t>(system.size()), false),
      bases_(exact_bases(system, at_shift(system, shift), exact)),
      n_own_{bases_.displacements.n(), bases_.phi.n()},
      slow_(system, shift),
      fast_(system, fast_share * shift) {
  for (int i = system.n_free(); i < system.size(); ++i) own_[static_cast<std::size_t>(i)] = true;
  for (const int i : exact) own_[static_cast<std::size_t>(i)] = true;
  if (!kept.empty()) {
    Eigen::MatrixXd columns(system.size(), static_cast<Eigen::Index>(kept.size()));
    for (std::size_t k = 0; k < kept.size(); ++k) columns.col(static_cast<Eigen::Index>(k)) = kept[k];
    add(bases_.displacements, {columns});
  }
  start_motions();
  start_loads();
  extend();
}

InterfaceSpace::~InterfaceSpace() = default;

int InterfaceSpace::n_solves() const {
  return slow_.n_solves() + fast_.n_solves();
}

void InterfaceSpace::start_motions() {
  const Eigen::MatrixXd degrees = by_degree(system_.interface->position);
  const Eigen::Index n = degrees.rows(), low = std::min(low_degrees, n), high = n - low;
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(system_.n_prescribed, 2 * n);
  motions.block(0, 0, n, low) = motions.block(n, low, n, low) = degrees.leftCols(low);
  motions.block(0, 2 * low, n, high) = motions.block(n, 2 * low + high, n, high) = degrees.rightCols(high);
  begin(slow_, slow_motions, slow_.follow(motions.leftCols(2 * low)));
  const Eigen::MatrixXd all = fast_.follow(motions);
  begin(fast_, fast_motions, all.leftCols(2 * low));
  if (high == 0) return;
  Eigen::MatrixXd local(system_.size(), 2 * n);
  local << product(all.middleCols(2 * low, high), degrees.rightCols(high).transpose()),
      product(all.rightCols(high), degrees.rightCols(high).transpose());
  carry(local);
}

/// Adds to the motion of each node what the ground does with it, by column.
void InterfaceSpace::carry(const Eigen::MatrixXd& local) {
  FieldBasis& basis = bases_.displacements;  // whose first columns are those of the prescribed unknowns
  for (Eigen::Index j = 0; j < local.cols(); ++j)
    for (std::size_t i = 0; i < basis.unknown.size(); ++i) {
      const int unknown = basis.unknown[i];
      const auto row = static_cast<Eigen::Index>(i);
      if (!own_[static_cast<std::size_t>(unknown)]) basis.vectors(row, j) = local(unknown, j) / basis.unit[row];
    }
}

void InterfaceSpace::start_loads() {
  std::vector<const Vector*> acting;
  for (const SystemLoad& load : system_.loads)
    if (load.vector.head(system_.n_free()).squaredNorm() > 0.) acting.push_back(&load.vector);
  if (acting.empty()) return;
  Eigen::MatrixXd loads(system_.size(), static_cast<Eigen::Index>(acting.size()));
  for (std::size_t k = 0; k < acting.size(); ++k) loads.col(static_cast<Eigen::Index>(k)) = *acting[k];
  begin(slow_, slow_loads, slow_.answer(loads));
  begin(fast_, fast_loads, fast_.answer(loads));
}

/// All starts get the length 1 in the norm of the bases, without the coordinates that are kept anyhow.
void InterfaceSpace::begin(MomentTrain& train, const int* orders, Eigen::MatrixXd first) {
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
  series_.push_back({&train, orders, std::move(first), {}});
}

void InterfaceSpace::take_level() {
  std::vector<Eigen::MatrixXd> columns;
  for (Series& series : series_) {
    if (level_ == 0) columns.push_back(series.now);
    for (; series.order < series.orders[level_]; ++series.order) {
      Eigen::MatrixXd next = series.train->next(series.now, series.before);
      series.before = std::exchange(series.now, std::move(next));
      columns.push_back(series.now);
    }
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
  for (int pass = 0; pass < 2 && n_old > 0; ++pass) {
    const Eigen::Ref<const Eigen::MatrixXd> old = basis.vectors.middleCols(n_own, n_old);
    Y -= product(old, transposed_product(old, Y));
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(transposed_product(Y, Y));  // ascending
  const double least = level_ < 0 ? detail::round_off : least_length[level_];
  const Eigen::Index m = (modes.eigenvalues().array() > least * least).count();
  if (m == 0) return;
  Eigen::MatrixXd V = product(Y, modes.eigenvectors().rightCols(m));
  for (int pass = 0; pass < 2; ++pass) {  // orthonormal to round-off by Cholesky's factor, twice
    const Eigen::LLT<Eigen::MatrixXd> factor(transposed_product(V, V));
    V = product(V, factor.matrixL().solve(Eigen::MatrixXd::Identity(m, m)).transpose());
  }
  for (Eigen::Index j = m - 1; j >= 0; --j)
    detail::add_column(basis, V.col(j), static_cast<int>(bases_.displacements.n() + bases_.phi.n()));
}

void InterfaceSpace::extend() {
  ++level_;
  take_level();
  if (projection_) {
    projection_->extend();
    if (radiating_) radiating_->extend();
    return;
  }
  projection_ = std::make_unique<Projection>(system_, bases_.displacements, bases_.phi, shift_);
  if (system_.radiation.nonZeros() == 0) return;
  radiation_.C = system_.radiation;
  radiation_.M = radiation_.K = SparseMatrix(system_.size(), system_.size());
  radiation_.field = system_.field;
  radiation_.n_prescribed = system_.n_prescribed;
  radiating_ = std::make_unique<Projection>(radiation_, bases_.displacements, bases_.phi, shift_);
}

namespace {

/// Coordinates of the reduced system, the prescribed ones last.
std::vector<int> order_of(const ReducedSystem& reduced) {
  std::vector<int> order;
  for (int i = reduced.n_prescribed; i < reduced.size(); ++i) order.push_back(i);
  for (int i = 0; i < reduced.n_prescribed; ++i) order.push_back(i);
  return order;
}

SparseMatrix in_order(const Eigen::MatrixXd& A, const std::vector<int>& order) {
  SparseMatrix sparse = A(order, order).eval().sparseView();
  sparse.makeCompressed();
  return sparse;
}

/// x, x' and x'' of all coordinates.
std::vector<Reading> coordinate_readings(int n) {
  std::vector<Reading> readings;
  for (int i = 0; i < n; ++i) readings.push_back(position_reading({"interface", i, "x"}, "", "", {{i, 1.}}));
  for (int i = 0; i < n; ++i) readings.push_back(velocity_reading({"interface", i, "v"}, "", "", {{i, 1.}}));
  for (int i = 0; i < n; ++i) readings.push_back(acceleration_reading({"interface", i, "a"}, "", "", {{i, 1.}}));
  return readings;
}

}  // namespace

InterfaceModel InterfaceSpace::model() const {
  const ReducedSystem& reduced = projection_->reduced();
  const std::vector<int> order = order_of(reduced);
  InterfaceModel model{{},
                       reduced.position(Eigen::all, order),
                       reduced.velocity(Eigen::all, order),
                       reduced.acceleration(Eigen::all, order),
                       reduced.feedthrough,
                       bases_.displacements,
                       bases_.phi};
  System& system = model.system;
  system.M = in_order(reduced.M, order);
  system.C = in_order(reduced.C, order);
  system.K = in_order(reduced.K, order);
  if (radiating_) system.radiation = in_order(radiating_->reduced().C, order);
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    const bool is_phi = reduced.is_phi[static_cast<std::size_t>(order[i])];
    system.field.push_back(is_phi ? Field::pressure_impulse : Field::displacement);
  }
  for (FieldBasis* basis : {&model.displacements, &model.phi})
    for (int& coordinate : basis->coordinate) coordinate = place[static_cast<std::size_t>(coordinate)];
  system.loads = system_.loads;
  for (std::size_t k = 0; k < system.loads.size(); ++k)
    system.loads[k].vector = reduced.load.col(static_cast<Eigen::Index>(k))(order);
  system.readings = coordinate_readings(reduced.size());
  system.n_prescribed = system_.n_prescribed;
  system.interface = system_.interface;
  system.frame_damping = system_.frame_damping;
  system.frame_radiation = system_.frame_radiation;
  return model;
}

Response InterfaceModel::read(Response response) const {
  const auto n = static_cast<Eigen::Index>(system.size());
  for (Series* series : {&response.ends, &response.balanced, &response.inside}) {
    const Eigen::MatrixXd& all = series->reading;
    if (all.cols() == 0) {
      series->reading.resize(position.rows(), 0);
      continue;
    }
    Eigen::MatrixXd reading = product(position, all.topRows(n)) + product(velocity, all.middleRows(n, n)) +
                              product(acceleration, all.bottomRows(n));
    if (feedthrough.cols() > 0) reading += feedthrough * series->load;
    series->reading = std::move(reading);
  }
  return response;
}

State InterfaceModel::whole(const State& state, bool only_phi) const {
  const auto n = static_cast<Eigen::Index>(displacements.unknown.size() + phi.unknown.size());
  State out{state.time, Vector::Zero(n), Vector::Zero(n), Vector::Zero(n)};
  const auto lift = [](const FieldBasis& basis, const Vector& from, Vector& to) {
    if (basis.unknown.empty()) return;
    const Vector q = from(basis.coordinate);
    to(basis.unknown) = Vector(product(basis.columns(), q)).cwiseProduct(basis.unit);
  };
  for (const FieldBasis* basis : {&phi, &displacements}) {
    if (only_phi && basis == &displacements) continue;
    lift(*basis, state.x, out.x);
    lift(*basis, state.v, out.v);
    lift(*basis, state.a, out.a);
  }
  return out;
}

}  // namespace upbead
