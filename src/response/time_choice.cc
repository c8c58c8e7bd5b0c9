#include "response/time_choice.h"

#include <algorithm>
#include <cmath>

#include "algebra/factorisation.h"
#include "base/numbers.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "fem/caisson/readings.h"
#include "response/load_step.h"
#include "system/part.h"
#include "upbead/dynamics/time_grid.h"

namespace upbead {

namespace {

/// Height above the centre of gravity at which the largest horizontal load acts on the caisson (m); 0 without one.
double arm_about_centre(const CompiledScene& compiled, double end) {
  const Caisson& caisson = *compiled.caisson;
  double largest = 0., arm = 0.;
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
    const LoadOnCaisson& load = compiled.loads_on_caisson[k];
    if (!load.arm()) continue;
    const TimeFunction& f = compiled.system.loads[k].history;
    const double peak = std::max(extremum(f, 0., end, 1).value, -extremum(f, 0., end, -1).value);
    if (std::abs(load.force_x) * peak <= largest) continue;
    largest = std::abs(load.force_x) * peak;
    arm = *load.arm() - (caisson.body.centre[1] - caisson.bottom_centre[1]);
  }
  return arm;
}

/// Finds the apparent period at a real s.
class PeriodFinder {
 public:
  PeriodFinder(const CompiledScene& compiled, double end, KnownPeriods& known)
      : system_(compiled.system),
        layout_(layout_of(system_)),
        mass_(compiled.caisson->body.mass),
        arm_(arm_about_centre(compiled, end)),
        known_(known),
        x_G_(row(reading::displacement_x)),
        b_(x_G_ + arm_ * row(reading::rotation)) {}

  double period(double s) {
    const auto [place, is_new] = known_.try_emplace({s, arm_});
    if (is_new) place->second = find(s);
    n_factorisations_ += place->second.second;
    return place->second.first;
  }
  /// Of all periods asked for, also where they were known.
  int n_factorisations() const { return n_factorisations_; }

 private:
  /// The apparent period; 0 where the caisson does not move with the force. A light caisson on soft ground, or one
  /// that the force turns more than it pushes, may only show a positive stiffness at a lower s.
  std::pair<double, int> find(double s) const {
    int halved = 0;
    for (; halved <= 4; ++halved, s /= 2.) {
      const Vector solution = solve(s);
      const double x = layout_.sum(x_G_.dot(solution));
      if (!(x > 0.)) continue;
      const double mass = mass_ + added_mass(solution, s, x), stiffness = 1. / x - mass * s * s;
      if (stiffness > 0.) return {2. * pi * std::sqrt(mass / stiffness), halved + 1};
    }
    return {0., halved};
  }

  /// By virtual work, the row of a displacement is the unit force that acts along it.
  Vector row(const char* name) const {
    Vector values = Vector::Zero(system_.n_free());
    for (const auto& [i, weight] : system_.readings[system_.reading(name)].position)
      if (i < values.size()) values[i] += weight;
    return values;
  }

  /// Added mass of the water: its force at x' = s x over -x'' = -s^2 x.
  double added_mass(const Vector& solution, double s, double x) const {
    double force = 0.;
    const Reading& water = system_.readings[system_.reading(reading::water_force)];
    for (const auto& [i, weight] : water.velocity)
      if (i < solution.size()) force += weight * s * solution[i];
    for (const auto& [i, weight] : water.acceleration)
      if (i < solution.size()) force += weight * s * s * solution[i];
    return -layout_.sum(force) / (s * s * x);
  }

  Vector solve(double s) const {
    const int n = system_.n_free();
    const SparseMatrix S = (s * s * system_.M + s * system_.C + system_.K).eval().topLeftCorner(n, n);
    return Factorisation(S, system_.blocks, system_.sharing).solve(b_);
  }

  const System& system_;
  Layout layout_;
  double mass_, arm_;
  KnownPeriods& known_;
  Vector x_G_, b_;
  int n_factorisations_ = 0;
};

std::string seconds(double value) {
  return significant(value, 4) + " s";
}

std::string reason(const LoadStep& loads, double period) {
  std::string text = !loads.lone_jump ? "shortest load " + seconds(loads.duration)
                     : period > 0.    ? "a lone jump"
                                      : "a lone jump, a 20th of the end " + seconds(loads.duration);
  if (period > 0.) text += ", apparent period " + seconds(period);
  if (loads.growth) text += ", growing after " + seconds(loads.growth->after);
  return text;
}

}  // namespace

StepChoice choose_step(const Scene& scene, const CompiledScene& compiled, int order, KnownPeriods* known) {
  const Stopwatch watch;
  const LoadStep loads = step_of_loads(scene, order);
  StepChoice choice;
  choice.growth = loads.growth;
  choice.largest_step = loads.largest_step;
  if (compiled.caisson && scene.time.inertia) {
    KnownPeriods none;
    PeriodFinder finder(compiled, scene.time.end, known != nullptr ? *known : none);
    double period = finder.period(pi / loads.duration);
    // The 20th of the end is only a start: the period must not depend on how long the run is.
    for (int i = 0; i < 2 && loads.lone_jump && period > 0.; ++i) period = finder.period(pi / period);
    choice.apparent_period = period;
    choice.factorisations = finder.n_factorisations();
    const double of_period = std::min(step_fraction(scene, order) * period, scene.time.end);
    if (period > 0.) choice.largest_step = loads.lone_jump ? of_period : std::min(of_period, loads.largest_step);
  }
  choice.reason = reason(loads, choice.apparent_period);
  choice.seconds = watch.seconds();
  return choice;
}

namespace {

constexpr double usual_vectors_per_load = 46.;
constexpr std::size_t most_independent = 3;  ///< forces on a rigid caisson: two and a moment
/// Time of a factorisation over that of a solve: 29 to 41 on four meshes of 22,000 to 360,000 unknowns.
constexpr double solves_per_factorisation = 35.;
/// Work that may be lost on a reduced model that does not converge, as a multiple of a march's work.
constexpr double risk = 1.;

std::string about(double n) {
  return "about " + std::to_string(10 * std::lround(n / 10.));
}

/// Solves of a march, at least: the apparent period of the caisson, which takes factorisations to find, and soil that
/// yields may ask for more.
double least_solves(const Scene& scene, const System& system) {
  const bool one_stage = scene.time.scheme == TimeScheme::generalised_alpha;
  const LoadStep loads = step_of_loads(scene, one_stage ? 2 : 4);
  const double step = scene.time.step.value_or(loads.largest_step);
  const std::optional<StepGrowth> growth = scene.time.step ? std::nullopt : loads.growth;
  const double steps = estimated_steps(kinks(system).size(), scene.time.end, step, growth);
  return (one_stage ? 1. : 5.) * steps;
}

/// What follows a number of least_solves.
std::string or_more(const Scene& scene) {
  return scene.time.step && !yields(scene) ? "" : " or more";
}

/// Factorisations of a march by sdirk4 besides its first, at least: one for each further length of step, and one for
/// the apparent period.
double further_factorisations(const Scene& scene, const System& system) {
  const double step = scene.time.step.value_or(step_of_loads(scene, 4).largest_step);
  const int lengths = make_time_grid(kinks(system), scene.time.end, step).n_step_sizes();
  return scene.time.step ? lengths - 1. : lengths;
}

/// Work of a reduced model with this number of vectors V, in solves of a march: each vector is solved for, made
/// orthogonal and projected; the eigenvalues of all looks together take as long as 4 V^3 / n solves with n unknowns.
/// Measured.
double work(double vectors, int unknowns) {
  return 1.5 * vectors + 4. * vectors * vectors * vectors / unknowns;
}

/// A scheme that is given, or a march where a reduced model cannot do.
std::optional<SchemeChoice> without_a_choice(const Scene& scene, const CompiledScene& compiled) {
  const std::string solves = about(least_solves(scene, compiled.system)) + " solves" + or_more(scene);
  const auto march = [&](const std::string& why) { return SchemeChoice{TimeScheme::sdirk4, why, {}, solves}; };
  if (scene.time.scheme == TimeScheme::reduced) return SchemeChoice{TimeScheme::reduced, "given in the case", {}};
  if (scene.time.scheme != TimeScheme::automatic)
    return SchemeChoice{scene.time.scheme, "given in the case", {}, solves};
  if (yields(scene)) return march("soil that yields is marched");
  if (!scene.time.inertia) return march("consolidation is marched");
  if (has_prescribed_motion(scene)) return march("a motion that is prescribed is marched");
  if (!compiled.caisson) return march("without a caisson there is no F_T to measure a reduced model's error with");
  if (scene.time.stop_at_energy) return march("it shall stop early");
  if (compiled.system.loads.empty()) return march("no load acts");
  return std::nullopt;
}

}  // namespace

SchemeChoice choose_scheme(const Scene& scene, const CompiledScene& compiled) {
  if (const auto only = without_a_choice(scene, compiled)) return *only;
  const System& system = compiled.system;
  const double marched = least_solves(scene, system);
  const double n_loads = static_cast<double>(std::min(system.loads.size(), most_independent));
  const int n_free = whole_size(system) - system.n_prescribed;
  const double reduced = std::min(usual_vectors_per_load * n_loads, static_cast<double>(n_free));
  if (const double equal = work(reduced, n_free); marched < equal)
    return {TimeScheme::sdirk4,
            about(marched) + " solves" + or_more(scene) + "; a reduced model would cost as much as " + about(equal),
            {}};
  const double marching = marched + solves_per_factorisation * further_factorisations(scene, system);
  double most = reduced;
  while (work(most + 1., n_free) < risk * marching) ++most;
  return {TimeScheme::reduced, about(reduced) + " solves instead of " + about(marched) + or_more(scene) + " of a march",
          static_cast<int>(most / n_loads)};
}

}  // namespace upbead
