// The generalised-alpha method.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dynamics/dirk.h"
#include "dynamics/products.h"
#include "dynamics/scheme_base.h"

namespace upbead::detail {

namespace {

/// Chung & Hulbert, J. Appl. Mech. 60 (1993) 371, eqs. (17), (18), (25); with rho the spectral radius at infinite
/// frequency: alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1), gamma = 1/2 - alpha_m + alpha_f,
/// beta = (1 - alpha_m + alpha_f)^2 / 4.
struct AlphaCoefficients {
  explicit AlphaCoefficients(double rho_inf);
  double alpha_m, alpha_f, gamma, beta;
};

/// M a_m + C v_f + K x_f = f_f with y_m = (1 - alpha_m) y_(n+1) + alpha_m y_n (alpha_f alike), solved for a_m. The
/// acceleration carried from step to step is only first order accurate. Where a load jumps, or a prescribed velocity
/// has a kink, and where steps lengthen, an L-stable step comes first: see `step_l_stable` and `is_lengthened`.
class GeneralisedAlpha : public SchemeBase {
 public:
  GeneralisedAlpha(const System& system, const SchemeOptions& options);
  std::string name() const override { return "generalised_alpha"; }
  int order() const override { return 2; }
  int solves_per_step() const override { return 1; }
  void start(const State& state) override;
  void advance(State& state, double h) override;
  SchemeMemory memory() const override;
  void recall(const SchemeMemory& memory) override;

 private:
  bool loads_start_anew(double t, double h);
  void note_end_load();
  bool is_lengthened(double h) const;
  void step_l_stable(State& state, double h);
  void predict(const State& state, double h, State& middle);
  void finish(State& state, double h) const;
  void account(const State& before, const State& after, double h);
  /// dv_f / da_m and dx_f / da_m.
  double v_gain(double h) const { return (1. - p_.alpha_f) * h * p_.gamma / (1. - p_.alpha_m); }
  double x_gain(double h) const { return (1. - p_.alpha_f) * h * h * p_.beta / (1. - p_.alpha_m); }

  AlphaCoefficients p_;
  SymmetricPair damping_and_stiffness_;
  Dirk sdirk4_;
  std::vector<double> begin_load_;
  std::vector<double> largest_load_;  ///< |f_k| so far, to tell a jump from round-off
  double last_step_ = 0.;             ///< s; 0 before the first; negative: a second L-stable step is due
  State before_;
  Vector x_, v_, f_, rhs_;
  VectorBlock pair_, triple_;
};

AlphaCoefficients::AlphaCoefficients(double rho_inf)
    : alpha_m((2. * rho_inf - 1.) / (rho_inf + 1.)),
      alpha_f(rho_inf / (rho_inf + 1.)),
      gamma(0.5 - alpha_m + alpha_f),
      beta(0.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f)) {
  if (!(rho_inf >= 0. && rho_inf <= 1.)) throw std::invalid_argument("generalised-alpha: rho_inf lies in [0, 1]");
}

GeneralisedAlpha::GeneralisedAlpha(const System& system, const SchemeOptions& options)
    : SchemeBase(system, options),
      p_(options.rho_inf),
      damping_and_stiffness_(system.C, system.K),
      sdirk4_(system, sdirk4_tableau()),
      largest_load_(system.loads.size(), 0.),
      pair_(system.size(), 2),
      triple_(system.size(), 3) {}

void GeneralisedAlpha::start(const State& state) {
  SchemeBase::start(state);
  std::fill(largest_load_.begin(), largest_load_.end(), 0.);
  last_step_ = 0.;
}

SchemeMemory GeneralisedAlpha::memory() const {
  SchemeMemory memory = SchemeBase::memory();
  memory.history = largest_load_;
  memory.last_step = last_step_;
  return memory;
}

void GeneralisedAlpha::recall(const SchemeMemory& memory) {
  SchemeBase::recall(memory);
  largest_load_ = memory.history;
  last_step_ = memory.last_step;
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

/// The step after a jump. There the velocities of soil that drains are infinite, velocities of parts without mass
/// jump, and so does x'' of a prescribed velocity. The generalised-alpha method multiplies an error of velocity by
/// -rho_inf in each step, so that it oscillates, and the displacement due to it stays: the sums of h v_f and of dx
/// differ by h (1/2 - alpha_f) times the change of v. One L-stable step damps motions faster than the step (as
/// Rannacher's: Numer. Math. 43 (1984) 309) and ends in x, x', x'' that obey the equations; in consolidation a third
/// of a percent of the largest pressure may stay. x'' of parts without mass still depends on how they moved within
/// that step; a second L-stable step makes it as smooth as the method assumes.
void GeneralisedAlpha::step_l_stable(State& state, double h) {
  advance_by(sdirk4_, state, h);
  note_end_load();
}

/// Whether the step is much longer than the one before. Long steps do not resolve motions at the pace of the short
/// ones: the method then overshoots by the square of the ratio of both (h v of a mode that should not move at all:
/// Hilber and Hughes, Earthq. Eng. Struct. Dyn. 6 (1978) 99). Therefore the first long steps are L-stable ones, which
/// damp such motions.
bool GeneralisedAlpha::is_lengthened(double h) const {
  constexpr double tolerable = 1.5;
  return last_step_ != 0. && h > tolerable * std::abs(last_step_);
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
  const bool first = loads_start_anew(state.time, h) || is_lengthened(h), second = last_step_ < 0.;
  last_step_ = first ? -h : h;
  if (first || second) return step_l_stable(state, h);
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

/// The equation of motion times dx = h <v> + h^2 (beta - gamma/2) da, where <.> is the mean of both ends and d. their
/// difference. With a_m = dv/h + (1/2 - alpha_f) da and x_f = <x> + (1/2 - alpha_f) dx its parts are the change of
/// the stored energy, v_f' C v_f h taken by damping and drag, and the rest, taken by the scheme.
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
  energy.add_frame(h, middle.v, balanced_.load);
  energy.add_work(1., rhs_, f_, middle.x, middle.v, middle.a);

  pair_.col(0) = middle.v;
  pair_.col(1) = rhs_ - h * middle.v;
  const Losses losses = energy.losses(pair_);
  energy.add_losses(losses, 0, h);
  energy.add_scheme(losses.total()(1, 0) + energy.coupling(pair_).total()(1, 0));
}

}  // namespace

std::unique_ptr<Scheme> make_generalised_alpha(const System& system, const SchemeOptions& options) {
  return std::make_unique<GeneralisedAlpha>(system, options);
}

}  // namespace upbead::detail
