#include "dynamics/slip_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/text.h"
#include "dynamics/state_space.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Share of |A| below which a pole's real part is round-off.
constexpr double no_growth = 1e-9;
/// Share of a position's row that may be outside strains and s, and count as round-off.
constexpr double no_slip_drift = 1e-6;

/// s' = A s + B f + b F_T with readings: n of N', `wanted`, velocity s'. s' is the last state, up to its unit.
struct OpenLoop {
  Eigen::MatrixXd A, B;
  Eigen::VectorXd b;
  Eigen::RowVectorXd n, n_load;  ///< N' = N_0 + n s + n_load f + n_shear F_T
  double n_shear = 0.;
  Eigen::RowVectorXd velocity;
  Eigen::MatrixXd wanted, wanted_load;
  Eigen::VectorXd wanted_shear;
  Eigen::VectorXd share_of_slip;
};

/// The system with its coordinates reordered: s, the only one on which the last load acts, comes last.
ReducedSystem with_slip_last(ReducedSystem r) {
  const Eigen::Index friction = r.load.cols() - 1;
  if (friction < 0 || r.load_name.back() != slip_name::friction)
    throw std::invalid_argument("the last load of a system that slips is its friction");
  Eigen::Index slip = 0;
  const double on_slip = -r.load.col(friction).cwiseAbs().maxCoeff(&slip);
  r.load.col(friction) = on_slip * Eigen::VectorXd::Unit(r.size(), slip);
  std::vector<int> order(static_cast<std::size_t>(r.size()));
  std::iota(order.begin(), order.end(), 0);
  std::rotate(order.begin() + slip, order.begin() + slip + 1, order.end());
  for (Eigen::MatrixXd* A : {&r.M, &r.C, &r.K}) *A = Eigen::MatrixXd((*A)(order, order));
  for (Eigen::MatrixXd* A : {&r.position, &r.velocity, &r.acceleration}) *A = Eigen::MatrixXd((*A)(Eigen::all, order));
  r.load = Eigen::MatrixXd(r.load(order, Eigen::all));
  std::vector<bool> is_phi;
  for (const int i : order) is_phi.push_back(r.is_phi[i]);
  r.is_phi = is_phi;
  return r;
}

/// Subtracts a position's share of s: a position that strains do not determine must be a multiple of s, plus strains.
void take_slip_out(StateSpace& s, int slip, int reading, double& share) {
  const double drift = s.E.row(reading).norm();
  if (drift == 0.) return;
  const double of_slip = s.E.row(slip).squaredNorm();
  if (of_slip > 0.) share = s.E.row(reading).dot(s.E.row(slip)) / of_slip;
  for (Eigen::MatrixXd* part : {&s.C, &s.D, &s.E, &s.F}) part->row(reading) -= share * part->row(slip);
  if (s.E.row(reading).norm() > no_slip_drift * drift)
    throw NumericsError("a reading of a caisson that slips is held by neither strain nor slip");
}

OpenLoop open_loop(const ReducedSystem& reduced, const SlipLaw& law) {
  StateSpace s = state_space(with_slip_last(reduced));
  const int slip = index_of(reduced.reading_label, slip_name::slip),
            velocity = index_of(reduced.reading_label, slip_name::velocity);
  const Eigen::Index K = s.B.cols() - 1;
  if (!s.D.row(velocity).isZero(0.)) throw NumericsError("the slip feels the motion that a load prescribes");
  OpenLoop o;
  o.A = s.A;
  o.B = s.B.leftCols(K);
  o.b = s.B.col(K);
  o.velocity = s.C.row(velocity);
  o.n.setZero(s.A.rows());
  o.n_load.setZero(K);
  for (const auto& [reading, weight] : law.normal_force) {
    if (!s.E.row(reading).isZero(0.)) throw std::invalid_argument("a normal force that is a position");
    o.n += weight * s.C.row(reading);
    o.n_load += weight * s.D.row(reading).head(K);
    o.n_shear += weight * s.D(reading, K);
  }
  o.share_of_slip.setZero(static_cast<Eigen::Index>(law.readings.size()));
  for (std::size_t i = 0; i < law.readings.size(); ++i) take_slip_out(s, slip, law.readings[i], o.share_of_slip[i]);
  o.wanted = s.C(law.readings, Eigen::all);
  o.wanted_load = s.D(law.readings, Eigen::seqN(0, K));
  o.wanted_shear = s.D(law.readings, K);
  return o;
}

/// The equations of a phase.
struct Equations {
  Eigen::MatrixXd A, B, C, D;
};

/// The equations under F_T = shear.s + shear_load.(f, N_0), for a phase whose states are the first ones of the open
/// loop.
Equations closed(const OpenLoop& o, const Eigen::RowVectorXd& shear, const Eigen::RowVectorXd& shear_load) {
  const Eigen::Index n = shear.size(), K = o.B.cols(), I = o.wanted.rows();
  Equations e;
  e.A = o.A.topLeftCorner(n, n) + o.b.head(n) * shear;
  e.B = o.b.head(n) * shear_load;
  e.B.leftCols(K) += o.B.topRows(n);
  e.C.setZero(first_row_wanted + I, n);
  e.D.setZero(first_row_wanted + I, K + 1);
  e.C.row(row_shear) = shear;
  e.D.row(row_shear) = shear_load;
  e.C.row(row_normal) = o.n.head(n) + o.n_shear * shear;
  e.D.row(row_normal) = o.n_shear * shear_load;
  e.D.row(row_normal).head(K) += o.n_load;
  e.D(row_normal, K) += 1.;
  e.C.row(row_velocity) = o.velocity.head(n);
  e.C.bottomRows(I) = o.wanted.leftCols(n) + o.wanted_shear * shear;
  e.D.bottomRows(I) = o.wanted_shear * shear_load;
  e.D.bottomLeftCorner(I, K) += o.wanted_load;
  return e;
}

Equations stuck(const OpenLoop& o) {
  const Eigen::Index n = o.A.rows() - 1, K = o.B.cols();
  Eigen::RowVectorXd shear_load = Eigen::RowVectorXd::Zero(K + 1);
  shear_load.head(K) = -o.B.row(n) / o.b[n];
  Equations e = closed(o, -o.A.row(n).head(n) / o.b[n], shear_load);
  e.C.row(row_velocity).setZero();
  return e;
}

Equations slipping(const OpenLoop& o, double friction) {
  const double loop = 1. - friction * o.n_shear;
  if (!(loop > 0.))
    throw NumericsError("with a friction of " + significant(std::abs(friction)) +
                        " slip is not well posed: the shear force that it makes adds as much normal force again");
  const double kappa = friction / loop;
  Eigen::RowVectorXd shear_load(o.B.cols() + 1);
  shear_load << kappa * o.n_load, kappa;
  return closed(o, kappa * o.n, shear_load);
}

/// Sets real parts of round-off to zero; returns the largest that is left.
double drop_growth(const Eigen::MatrixXd& A, Eigen::VectorXcd& pole) {
  const double round_off = no_growth * A.norm();
  double growth = 0.;
  for (std::complex<double>& p : pole) {
    if (p.real() <= round_off) p.real(std::min(p.real(), 0.));
    growth = std::max(growth, p.real());
  }
  return growth;
}

/// What answers its loads, in modes; no state is needed, so none is turned into modes.
ModalModel answers_in_modes(const Equations& e) {
  ModalModel model;
  detail::Modes modes = detail::diagonalise(e.A, e.B);
  drop_growth(e.A, modes.pole);
  const std::vector<int> kept = modes.kept();
  model.pole = modes.pole(kept);
  model.load = modes.load(kept, Eigen::all);
  model.reading = modes.reading(e.C * modes.X, kept);
  model.feedthrough = e.D;
  model.impulse.setZero(e.D.rows(), e.D.cols());
  return model;
}

/// The modes of a phase; `n_states`: number of states of the open loop.
SlipPhase in_modes(const Equations& e, Eigen::Index n_states, double& growth) {
  const Eigen::Index n = e.A.rows();
  SlipPhase phase;
  phase.modes.feedthrough = e.D;
  phase.modes.impulse.setZero(e.D.rows(), e.D.cols());
  detail::Modes modes;
  if (n > 0) modes = detail::diagonalise(e.A, Eigen::MatrixXd::Identity(n, n));
  growth = std::max(growth, drop_growth(e.A, modes.pole));
  std::vector<int> kept = modes.kept();
  std::stable_partition(kept.begin(), kept.end(), [&](int m) { return modes.pole[m].imag() > 0.; });
  const auto M = static_cast<Eigen::Index>(kept.size());
  phase.modes.pole = modes.pole(kept);
  const Eigen::MatrixXcd inverse = modes.load(kept, Eigen::all), X = modes.reading(modes.X, kept);
  phase.modes.load = inverse * e.B;
  phase.modes.reading = e.C * X;
  phase.to_state.setZero(n_states, 2 * M);
  phase.to_state.topRows(n) << X.real(), -X.imag();
  phase.from_state.setZero(2 * M, n_states);
  phase.from_state.leftCols(n) << inverse.real(), inverse.imag();
  return phase;
}

void add_labels(ModalModel& modes, const ReducedSystem& reduced, const std::vector<int>& wanted) {
  modes.load_name.assign(reduced.load_name.begin(), reduced.load_name.end() - 1);
  modes.load_name.emplace_back("interface/normal_force");
  modes.reading_label = {{slip_name::friction, "N/m", "F_T, shear force on the ground, landward"},
                         {"interface/normal_force", "N/m", "N', effective normal force, compression positive"},
                         {slip_name::velocity, "m/s", "velocity of the slip, landward"}};
  for (const int i : wanted) modes.reading_label.push_back(reduced.reading_label[i]);
}

/// The readings of two models one after the other; the second has all loads, the first all but the last.
ModalModel side_by_side(const ModalModel& a, const ModalModel& b) {
  const Eigen::Index m = a.n_modes(), n = b.n_modes(), i = a.n_readings(), j = b.n_readings();
  ModalModel both;
  both.pole.resize(m + n);
  both.pole << a.pole, b.pole;
  both.load.setZero(m + n, b.n_loads());
  both.load.topLeftCorner(m, a.n_loads()) = a.load;
  both.load.bottomRows(n) = b.load;
  both.reading.setZero(i + j, m + n);
  both.reading.topLeftCorner(i, m) = a.reading;
  both.reading.bottomRightCorner(j, n) = b.reading;
  both.feedthrough.setZero(i + j, b.n_loads());
  both.feedthrough.topLeftCorner(i, a.n_loads()) = a.feedthrough;
  both.feedthrough.bottomRows(j) = b.feedthrough;
  both.impulse.setZero(i + j, b.n_loads());
  return both;
}

/// Largest damping ratio at s_0 that may be added.
constexpr double largest_ratio = 5e-3;

SlipModel model_with(const ReducedSystem& reduced, const SlipLaw& law, double damping_time) {
  if (!(law.friction > 0.)) throw std::invalid_argument("slip needs friction");
  ReducedSystem damped = reduced;
  if (damping_time > 0.) damped.C += damping_time * reduced.K;
  const OpenLoop loop = open_loop(damped, law);
  SlipModel model;
  model.friction = law.friction;
  model.damping_time = damping_time;
  model.share_of_slip = loop.share_of_slip;
  const std::array<Equations, 4> equations{stuck(loop), slipping(loop, law.friction), slipping(loop, -law.friction),
                                           slipping(loop, 0.)};
  for (std::size_t i = 0; i < equations.size(); ++i) {
    model.phases[i] = in_modes(equations[i], loop.A.rows(), model.growth);
    add_labels(model.phases[i].modes, reduced, law.readings);
  }
  return model;
}

/// The largest 2 sigma/omega^2 among growing poles for which this is no more than half of `largest`.
double beta_against_flutter(const SlipModel& model, double largest) {
  double beta = 0.;
  for (const SlipPhase& phase : model.phases)
    for (const std::complex<double>& pole : phase.modes.pole) {
      const double wanted = pole.real() > 0. ? 2. * pole.real() / std::norm(pole) : 0.;
      if (2. * wanted <= largest) beta = std::max(beta, wanted);
    }
  return beta;
}

}  // namespace

void add_slip(System& system, int slip) {
  system.loads.push_back({slip_name::friction, -Vector::Unit(system.size(), slip), TimeFunction(), -1});
  system.readings.push_back(position_reading(slip_name::slip, "m", "slip, landward", {{slip, 1.}}));
  system.readings.push_back(
      velocity_reading(slip_name::velocity, "m/s", "velocity of the slip, landward", {{slip, 1.}}));
}

SlipModel slip_model(const ReducedSystem& reduced, const SlipLaw& law, double damping_time) {
  constexpr int most_tries = 8;
  double beta = damping_time;
  SlipModel model = model_with(reduced, law, beta);
  for (int i = 0; i < most_tries; ++i) {
    const double wanted = beta_against_flutter(model, 2. * largest_ratio / reduced.shift - beta);
    if (wanted == 0.) break;
    beta += 2. * wanted;
    model = model_with(reduced, law, beta);
  }
  return model;
}

ModalModel stuck_and_free(const ReducedSystem& reduced, const SlipLaw& law) {
  const OpenLoop loop = open_loop(reduced, law);
  const Eigen::Index N = loop.A.rows(), K = loop.B.cols();
  Equations together = stuck(loop);
  together.B = Eigen::MatrixXd(together.B.leftCols(K));
  together.C = Eigen::MatrixXd(together.C({row_shear, row_normal}, Eigen::all));
  together.D = Eigen::MatrixXd(together.D({row_shear, row_normal}, Eigen::seqN(0, K)));
  Equations apart{loop.A, Eigen::MatrixXd(N, K + 1), Eigen::MatrixXd(2, N), Eigen::MatrixXd::Zero(2, K + 1)};
  apart.B << loop.B, loop.b;
  apart.C << loop.velocity, loop.n;
  apart.D.row(1) << loop.n_load, loop.n_shear + 1.;
  ModalModel both = side_by_side(answers_in_modes(together), answers_in_modes(apart));
  for (const int row : {1, 3}) {
    both.reading.row(row) += both.reading.row(0);
    both.feedthrough.row(row) += both.feedthrough.row(0);
  }
  both.load_name = reduced.load_name;
  both.reading_label = {{"stuck/shear_force", "N/m", "F_T"},
                        {"stuck/limit", "N/m", "F_T + change of N'"},
                        {"free/slip_velocity", "m/s", "s'"},
                        {"free/limit", "N/m", "both F_T + change of N'"}};
  return both;
}

}  // namespace upbead
