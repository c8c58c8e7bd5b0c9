#include "generalised_alpha.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace upbead::detail {

AlphaCoefficients::AlphaCoefficients(double rho_inf)
    : alpha_m((2. * rho_inf - 1.) / (rho_inf + 1.)),
      alpha_f(rho_inf / (rho_inf + 1.)),
      gamma(0.5 - alpha_m + alpha_f),
      beta(0.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f)) {
  if (!(rho_inf >= 0. && rho_inf <= 1.)) throw std::invalid_argument("generalised-alpha: rho_inf lies in [0, 1]");
}

namespace {

/// M of displacements is positive, that of phi (compressibility) negative.
bool is_massless(const SparseMatrix& M) {
  for (Eigen::Index i = 0; i < M.rows(); ++i)
    if (M.coeff(i, i) > 0.) return false;
  return true;
}

}  // namespace

GeneralisedAlpha::GeneralisedAlpha(const System& system, double rho_inf, bool account_energy)
    : SchemeBase(system, account_energy),
      p_(rho_inf),
      damping_and_stiffness_(system.C, system.K),
      euler_(system, euler_tableau()),
      sdirk4_(system, sdirk4_tableau()),
      massless_(is_massless(system.M)),
      largest_load_(system.loads.size(), 0.),
      pair_(system.size(), 2),
      triple_(system.size(), 3) {}

void GeneralisedAlpha::start(const State& state) {
  SchemeBase::start(state);
  std::fill(largest_load_.begin(), largest_load_.end(), 0.);
}

SchemeMemory GeneralisedAlpha::memory() const {
  SchemeMemory memory = SchemeBase::memory();
  memory.largest_load = largest_load_;
  return memory;
}

void GeneralisedAlpha::recall(const SchemeMemory& memory) {
  SchemeBase::recall(memory);
  largest_load_ = memory.largest_load;
}

/// Whether a load jumps at t, or a prescribed velocity has a kink there (its acceleration jumps).
bool GeneralisedAlpha::loads_start_anew(double t, double h) {
  loads_.evaluate(t, t + 0.5 * h, begin_load_);
  for (std::size_t k = 0; k < begin_load_.size(); ++k) {
    const SystemLoad& load = system_.loads[k];
    const auto at_t = [&](double kink) { return std::abs(kink - t) < 1e-6 * h; };
    const bool at_start = at_t(0.);
    if (!at_start && std::none_of(load.history.kinks().begin(), load.history.kinks().end(), at_t)) continue;
    if (load.prescribed >= 0) return true;
    const double before = at_start ? 0. : load.history(t, t - 1e-3 * h);
    const double size = std::max({largest_load_[k], std::abs(before), std::abs(begin_load_[k])});
    if (std::abs(begin_load_[k] - before) > 1e-9 * size) return true;
  }
  return false;
}

void GeneralisedAlpha::note_end_load() {
  for (std::size_t k = 0; k < end_load_.size(); ++k)
    largest_load_[k] = std::max(largest_load_[k], std::abs(end_load_[k]));
}

/// x''(t+) where M may be singular: three steps of backward Euler so small that only what jumps moves. The first
/// carries over what jumps without mass to hold it (a displacement in a quasi-static scene), the second what jumps in
/// x' (a pressure that only obeys a constraint, a prescribed velocity), the third finds x'' of the consistent state.
/// Time stands still meanwhile, an error of 3e-6 h.
void GeneralisedAlpha::start_anew(State& state, double h) {
  const double t = state.time;
  for (int i = 0; i < 3; ++i) {
    euler_.step(state, 1e-6 * h, t + 0.5 * h, matrices_, meter());
    state.time = t;
    ++n_solves_;
  }
}

/// The step after a jump where nothing has mass. Velocities of a soil that drains are infinite there. The method hands
/// on -rho_inf of a wrong velocity, which swings from step to step, and what it has moved stays: the sums of h v_f and
/// of dx differ by h (1/2 - alpha_f) times the change of v. One L-stable step damps what is faster than the step (as
/// Rannacher's: Numer. Math. 43 (1984) 309); a third of a percent of the largest pressure may stay.
void GeneralisedAlpha::step_from_jump(State& state, double h) {
  sdirk4_.step(state, h, state.time + 0.5 * h, matrices_, meter());
  n_solves_ += sdirk4_.n_stages();
  end_load_ = sdirk4_.load();
  note_end_load();
  balanced_ = {state, end_load_};
}

/// x_f and v_f for a_m = 0 (into x_, v_), and the known part of a_m for prescribed unknowns.
void GeneralisedAlpha::predict(const State& state, double h, State& middle) {
  const double a_weight = -p_.alpha_m / (1. - p_.alpha_m);
  const double v_weight = h * (1. - p_.gamma + p_.gamma * a_weight);
  const double x_weight = h * h * (0.5 - p_.beta + p_.beta * a_weight);
  v_ = state.v + (1. - p_.alpha_f) * v_weight * state.a;
  x_ = state.x + (1. - p_.alpha_f) * (h * state.v + x_weight * state.a);
  if (const int n = system_.n_prescribed; n > 0) {
    loads_.prescribe(end_load_, middle.v);
    middle.v.tail(n) = ((1. - p_.alpha_f) * middle.v.tail(n) + p_.alpha_f * state.v.tail(n)).eval();
    middle.a.tail(n) = (middle.v.tail(n) - v_.tail(n)) / v_gain(h);
  }
}

/// v_(n+1), x_(n+1) from a_m, by Newmark's relations.
void GeneralisedAlpha::finish(State& state, double h) const {
  const Vector& a_m = balanced_.state.a;
  state.x += h * state.v + h * h * (0.5 - p_.beta) * state.a;
  state.v += h * (1. - p_.gamma) * state.a;
  state.a = (a_m - p_.alpha_m * state.a) / (1. - p_.alpha_m);
  state.x += h * h * p_.beta * state.a;
  state.v += h * p_.gamma * state.a;
  state.time += h;
}

void GeneralisedAlpha::advance(State& state, double h) {
  if (loads_start_anew(state.time, h)) {
    if (massless_) return step_from_jump(state, h);
    start_anew(state, h);
  }
  before_ = state;
  loads_.evaluate(state.time + h, state.time + 0.5 * h, end_load_);
  std::vector<double>& load = balanced_.load;
  for (std::size_t k = 0; k < load.size(); ++k)
    load[k] = (1. - p_.alpha_f) * end_load_[k] + p_.alpha_f * begin_load_[k];
  note_end_load();
  loads_.sum(load, f_);

  State& middle = balanced_.state;
  predict(state, h, middle);
  rhs_ = f_;
  damping_and_stiffness_.subtract_products(v_, x_, rhs_);
  matrices_.get({1., v_gain(h), x_gain(h)}).solve(rhs_, middle.a);
  ++n_solves_;
  middle.time = state.time + (1. - p_.alpha_f) * h;
  middle.v = v_ + v_gain(h) * middle.a;
  middle.x = x_ + x_gain(h) * middle.a;
  finish(state, h);
  if (meter() != nullptr) account(before_, state, h);
}

/// The balance times dx = h <v> + h^2 (beta - gamma/2) da, where <.> is the mean of both ends and d. their difference.
/// With a_m = dv/h + (1/2 - alpha_f) da and x_f = <x> + (1/2 - alpha_f) dx its parts are the change of what is stored,
/// v_f' C v_f h taken by damping and drag, and the rest, taken by the scheme.
void GeneralisedAlpha::account(const State& before, const State& after, double h) {
  EnergyMeter& energy = *meter();
  const State& middle = balanced_.state;
  const double e = 0.5 - p_.alpha_f, d = h * (p_.beta - 0.5 * p_.gamma);

  triple_.col(0) = after.v;
  triple_.col(1) = after.v - before.v;
  triple_.col(2) = after.a - before.a;
  const FieldGrams mass = energy.mass(triple_);
  const Eigen::MatrixXd m = mass.total();
  const double mean_v_da = m(0, 2) - 0.5 * m(1, 2);
  energy.add_scheme(h * e * mean_v_da + d * m(1, 2) + h * d * e * m(2, 2));

  pair_.col(0) = after.x;
  pair_.col(1) = after.x - before.x;
  const FieldGrams stiffness = energy.stiffness(pair_);
  energy.add_scheme(e * stiffness.total()(1, 1));
  energy.set_stored(mass, stiffness, 0);
  rhs_ = pair_.col(1);
  energy.add_work(1., rhs_, f_, middle.x, middle.v, middle.a);

  pair_.col(0) = middle.v;
  pair_.col(1) = rhs_ - h * middle.v;
  const Losses losses = energy.losses(pair_);
  energy.add_losses(losses, 0, h);
  energy.add_scheme(losses.total()(1, 0) + energy.coupling(pair_).total()(1, 0));
}

}  // namespace upbead::detail
