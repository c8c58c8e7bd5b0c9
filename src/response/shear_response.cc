#include "response/shear_response.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "dynamics/interpolate.h"
#include "fem/caisson/readings.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr std::size_t most_looks = 16;

std::size_t looks_of(std::size_t n_steps) {
  return std::clamp<std::size_t>(most_looks * 512 / n_steps, 1, most_looks);
}

using Samples = Eigen::RowVectorXd;

/// The values of a reading at all times of a series.
Samples samples(const CompiledScene& compiled, const Series& series, const char* name) {
  return series.reading.row(compiled.system.reading(name));
}

/// Evaluates some points of every step, and many points near the step with the largest value.
template <typename Value>
Extremum extreme(const std::vector<double>& time, int sign, const Value& value) {
  const std::size_t n_steps = time.size() - 1, looks = looks_of(n_steps);
  Extremum best{time.front(), 0.};
  std::size_t step = 0;
  for (std::size_t n = 0; n < n_steps; ++n)
    for (std::size_t i = 0; i <= looks; ++i) {
      const double t = time[n] + (time[n + 1] - time[n]) * static_cast<double>(i) / static_cast<double>(looks);
      if (const double y = value(n, t); sign * (y - best.value) > 0.) {
        best = {t, y};
        step = n;
      }
    }
  for (std::size_t n = step > 0 ? step - 1 : 0; n < std::min(step + 2, n_steps); ++n) {
    const TimeFunction inside({}, {[&](double t) { return value(n, t); }});
    const Extremum candidate = extremum(inside, time[n], time[n + 1], sign, most_looks);
    if (sign * (candidate.value - best.value) > 0.) best = candidate;
  }
  return best;
}

/// F_T and x_G between the ends of each step. With a scheme of order 4, x_G, x_G' and x_G'' are accurate enough for a
/// quintic. With order 2 their errors, divided by h^2, would spoil its second derivative, so x_G'' is taken as
/// linear; the same is done in steps so short that round-off would spoil it.
///
/// The water reacts to acceleration at once, so its force is taken as -m_a x_G'' + r: the added mass m_a is fitted to
/// the whole march, r is small and linear within a step, and where P jumps, x_G'' jumps by the jump of P over m +
/// m_a.
class InsideSteps {
 public:
  InsideSteps(const CompiledScene& compiled, const Response& response, const TimeFunction& P)
      : time_(response.ends.time),
        x_(samples(compiled, response.ends, reading::displacement_x)),
        v_(samples(compiled, response.ends, reading::velocity_x)),
        P_(P),
        mass_(compiled.caisson->body.mass),
        quintic_(response.ends.time.size() - 1, response.order >= 4) {
    const Samples water = samples(compiled, response.ends, reading::water_force);
    a_ = (water - samples(compiled, response.ends, reading::shear_force)) / mass_;
    for (std::size_t n = 1; n < time_.size(); ++n)
      a_[static_cast<Eigen::Index>(n)] += P_(time_[n], middle(n - 1)) / mass_;
    all_added_mass_ = added_mass(water);
    for (std::size_t n = 0; n < quintic_.size(); ++n) quintic_[n] = quintic_[n] && is_smooth(n);
  }

  /// Extreme of P + `water` - m x_G'', where `water` is a force of the water at the ends of the steps.
  Extremum shear_force(int sign, const Samples& water) const {
    const WaterPart part = split(water);
    return extreme(time_, sign, [&](std::size_t n, double t) { return shear_force_at(n, t, part); });
  }
  Extremum displacement(int sign) const {
    return extreme(time_, sign, [this](std::size_t n, double t) { return motion(n)(t).value; });
  }

  /// Calls `see` with times, P + `water` - m x_G'' and P: from the start of each step to its end in up to 16 equal
  /// parts.
  template <class See>
  void for_each(const Samples& water, const See& see) const {
    const WaterPart part = split(water);
    const std::size_t n_steps = time_.size() - 1, looks = looks_of(n_steps);
    for (std::size_t n = 0; n < n_steps; ++n)
      for (std::size_t i = 0; i <= looks; ++i) {
        const double weight = static_cast<double>(i) / static_cast<double>(looks);
        const double t = (1. - weight) * time_[n] + weight * time_[n + 1];
        see(t, shear_force_at(n, t, part), P_(t, middle(n)));
      }
  }

 private:
  /// The force of the water: -m_a x_G'' + rest, where rest is linear within a step.
  struct WaterPart {
    double added_mass;
    Samples rest;
  };
  WaterPart split(const Samples& water) const {
    const double m_a = added_mass(water);
    return {m_a, water + m_a * a_};
  }

  double shear_force_at(std::size_t n, double t, const WaterPart& water) const {
    const auto k = static_cast<Eigen::Index>(n);
    const double weight = (t - time_[n]) / (time_[n + 1] - time_[n]);
    return P_(t, middle(n)) + (1. - weight) * water.rest[k] + weight * water.rest[k + 1] -
           (mass_ + water.added_mass) * acceleration_at(n, t);
  }

  double middle(std::size_t n) const { return 0.5 * (time_[n] + time_[n + 1]); }

  /// x_G'' at one end of step n, with P of that step's own piece.
  double acceleration(std::size_t n, std::size_t end) const {
    const double a = a_[static_cast<Eigen::Index>(end)];
    if (end != n) return a;
    const double before = n == 0 ? 0. : P_(time_[n], middle(n - 1));
    return a + (P_(time_[n], middle(n)) - before) / (mass_ + all_added_mass_);
  }
  double acceleration_at(std::size_t n, double t) const {
    if (quintic_[n]) return motion(n)(t).second;
    const double weight = (t - time_[n]) / (time_[n + 1] - time_[n]);
    return (1. - weight) * acceleration(n, n) + weight * acceleration(n, n + 1);
  }
  QuinticHermite motion(std::size_t n) const {
    const auto jet = [&](std::size_t end) {
      const auto k = static_cast<Eigen::Index>(end);
      return Jet{x_[k], v_[k], acceleration(n, end)};
    };
    return QuinticHermite(time_[n], time_[n + 1] - time_[n], jet(n), jet(n + 1));
  }
  /// Mean jerk of step n.
  double jerk(std::size_t n) const { return (acceleration(n, n + 1) - acceleration(n, n)) / (time_[n + 1] - time_[n]); }

  /// Whether the quintic through x and v bends x_G'' away from a straight line by no more than its slope changes from
  /// step to step. A larger bend is round-off of x and v, divided by h^2.
  bool is_smooth(std::size_t n) const {
    const double h = time_[n + 1] - time_[n], own = jerk(n);
    double change = n > 0 ? std::abs(own - jerk(n - 1)) : std::abs(own);
    if (n + 2 < time_.size()) change = std::max(change, std::abs(own - jerk(n + 1)));
    const QuinticHermite x = motion(n);
    double bend = 0.;
    for (const double part : {0.25, 0.5, 0.75})
      bend = std::max(bend, std::abs(x(time_[n] + part * h).second - acceleration(n, n) - part * h * own));
    return bend <= 2. * h * change;
  }

  /// Least squares of water = -m_a x_G''.
  double added_mass(const Samples& water) const {
    const double square = a_.squaredNorm();
    return square > 0. ? std::max(0., -water.dot(a_) / square) : 0.;
  }

  const std::vector<double>& time_;
  Samples x_, v_, a_;  ///< a at the end of each step, with P of that step
  const TimeFunction& P_;
  double mass_;
  double all_added_mass_;
  std::vector<bool> quintic_;  ///< whether x_G is a quintic, by step
};

Extremum at_ends(const std::vector<double>& time, const Samples& values, int sign) {
  Eigen::Index at = 0;
  (sign * values).maxCoeff(&at);
  return {time[static_cast<std::size_t>(at)], values[at]};
}

/// Height of the resultant of all loads above the bottom at one time (m); at a jump of the loads before or after it.
std::optional<double> arm_at(const CompiledScene& compiled, double time, bool before) {
  constexpr double hair = 1e-9;
  LoadOnCaisson total;
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
    const double f = compiled.system.loads[k].history(time, before ? time * (1. - hair) : time);
    total.force_x += compiled.loads_on_caisson[k].force_x * f;
    total.moment += compiled.loads_on_caisson[k].moment * f;
  }
  return total.arm();
}

double largest(const Samples& values) {
  return values.cwiseAbs().maxCoeff();
}

/// The value of largest magnitude, with its sign.
double farthest_of(const Samples& values) {
  return std::max(values.maxCoeff(), values.minCoeff(), [](double a, double b) { return std::abs(a) < std::abs(b); });
}

/// Whether the largest |P| is seaward.
bool is_seaward(const ShearResponse& r) {
  return -r.peak_force_seaward > r.peak_force;
}

void set_forces(ShearResponse& r, const TimeFunction& P, double end) {
  const Extremum landward = extremum(P, 0., end, 1), seaward = extremum(P, 0., end, -1);
  r.peak_force = landward.value;
  r.peak_force_time = landward.time;
  r.peak_force_seaward = seaward.value;
  r.peak_force_seaward_time = seaward.time;
  r.impulse = integral(P, 0., end);
}

/// Peaks of F_T, of its other readings, and of the motion.
void set_peaks(ShearResponse& r, const CompiledScene& compiled, const Response& response, const TimeFunction& P,
               bool inertia) {
  const std::vector<double>& time = response.ends.time;
  const auto of = [&](const char* name) { return samples(compiled, response.ends, name); };
  const Samples F_T = of(reading::shear_force), water = of(reading::water_force),
                front = of(reading::water_force_front);
  const InsideSteps inside(compiled, response, P);
  const auto peak = [&](int sign, const Samples& part) {
    return inertia ? inside.shear_force(sign, part) : at_ends(time, F_T - water + part, sign);
  };
  const Extremum landward = peak(1, water), seaward = peak(-1, water);
  r.peak_shear = landward.value;
  r.peak_shear_time = landward.time;
  r.peak_shear_seaward = seaward.value;
  r.peak_shear_seaward_time = seaward.time;
  r.peak_shear_paper = peak(1, 0. * water).value;
  r.peak_shear_experiment = peak(1, front).value;
  const auto moved = [&](int sign) {
    return inertia ? inside.displacement(sign) : at_ends(time, of(reading::displacement_x), sign);
  };
  const Extremum forth = moved(1), back = moved(-1);
  r.peak_displacement = forth.value;
  const Extremum& farthest = -back.value > forth.value ? back : forth;
  r.largest_displacement = farthest.value;
  r.largest_displacement_time = farthest.time;
  const Samples rotation = of(reading::rotation), moment = of(reading::base_moment);
  r.peak_rotation = rotation.maxCoeff();
  r.largest_rotation = farthest_of(rotation);
  r.peak_base_moment = moment.maxCoeff();
  r.largest_base_moment = farthest_of(moment);
}

/// Ratios of the peaks in the direction of the largest |P|.
void set_ratios(ShearResponse& r, double duration) {
  const double force = is_seaward(r) ? r.peak_force_seaward : r.peak_force;
  const double shear = is_seaward(r) ? r.peak_shear_seaward : r.peak_shear;
  if (force != 0.) r.shear_to_force_ratio = shear / force;
  if (std::abs(r.impulse) > 1e-9 * std::abs(force) * duration) r.shear_to_impulse = shear / r.impulse;
}

}  // namespace

TimeFunction force_on_caisson(const CompiledScene& compiled) {
  TimeFunction P;
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k)
    if (const double weight = compiled.loads_on_caisson[k].force_x; weight != 0.)
      P = sum(P, scaled(compiled.system.loads[k].history, weight));
  return P;
}

double reaction_mismatch(const CompiledScene& compiled, const Response& response) {
  const TimeFunction P = force_on_caisson(compiled);  // its peak may lie between the times of the series
  const double end = response.ends.time.back();
  const auto of = [&](const char* name) { return samples(compiled, response.balanced, name); };
  const double scale = std::max(largest(of(reading::shear_force)),
                                1e-6 * std::max({extremum(P, 0., end, 1).value, -extremum(P, 0., end, -1).value,
                                                 largest(of(reading::normal_force)), largest(of(reading::uplift)),
                                                 largest(of(reading::base_moment)) / compiled.caisson->bottom_width}));
  return scale > 0. ? largest(of(reading::shear_force) - of(reading::shear_by_inertia)) / scale : 0.;
}

ShearResponse read_shear_response(const CompiledScene& compiled, const Response& response, bool inertia) {
  const TimeFunction P = force_on_caisson(compiled);
  const double end = response.ends.time.back();
  ShearResponse r;
  set_forces(r, P, end);
  set_peaks(r, compiled, response, P, inertia);
  set_ratios(r, end);
  const double peak_time = is_seaward(r) ? r.peak_force_seaward_time : r.peak_force_time;
  r.arm = arm_at(compiled, peak_time, true);
  if (!r.arm) r.arm = arm_at(compiled, peak_time, false);  // a load that jumps from zero
  r.reaction_mismatch = reaction_mismatch(compiled, response);
  return r;
}

BaseHistory read_base_history(const CompiledScene& compiled, const Response& response, bool inertia) {
  const Series& ends = response.ends;
  const auto of_steps = [&](const char* name) {
    const Samples values = samples(compiled, ends, name);
    return History{ends.time, {values.begin(), values.end()}};
  };
  BaseHistory history{{}, {}, of_steps(reading::normal_force), of_steps(reading::uplift)};
  if (!inertia) {
    history.shear_force = of_steps(reading::shear_force);
    history.force = of_steps(reading::force);
    return history;
  }
  const TimeFunction P = force_on_caisson(compiled);
  const InsideSteps inside(compiled, response, P);
  History &shear = history.shear_force, &force = history.force;
  inside.for_each(samples(compiled, ends, reading::water_force), [&](double t, double F_T, double P_t) {
    if (!shear.time.empty() && t == shear.time.back() && F_T == shear.value.back() && P_t == force.value.back())
      return;  // nothing jumps between these steps
    shear.time.push_back(t);
    shear.value.push_back(F_T);
    force.value.push_back(P_t);
  });
  force.time = shear.time;
  return history;
}

namespace {

constexpr double bearable = 1e-4;

/// Throws where energy is made: generalised-alpha overshoots in steps much longer than the periods of a scene (Hilber
/// and Hughes, Earthq. Eng. Struct. Dyn. 6 (1978) 99), and more where long steps follow the short ones of a pulse.
void require_no_gain(const EnergyAccount& energy, double work) {
  constexpr double tolerable = 1.1;
  if (energy.stored() <= tolerable * work) return;
  throw NumericsError("the scene holds " + significant(energy.stored() / work, 6) +
                      " times the work of the loads, the rest of which the time scheme has made up: the steps are too "
                      "long; shorten time.step, or leave it to the program: \"auto\"");
}

constexpr double tolerable_energy = 1e-6;
const std::string energies_differ = "the work of the loads and the sum of all energies differ";

/// 1/2 sum of (peak b_i)^2 / K_ii, a measure of the work that the loads could do statically if each acted alone; for
/// a load that prescribes a pressure, b is the force of that pressure.
double possible_work(const System& system, double end) {
  const Vector stiffness = values_of(system, system.K.diagonal()).cwiseAbs();
  Vector work = Vector::Zero(system.size());
  for (const SystemLoad& load : system.loads) {
    const double peak = std::max(extremum(load.history, 0., end, 1).value, -extremum(load.history, 0., end, -1).value);
    Vector push = Vector::Zero(system.size());
    for (int i = 0; i < system.n_free(); ++i)
      push[i] = load.prescribed < 0 ? load.vector[i] : system.C.coeff(i, load.prescribed);
    push = values_of(system, std::move(push));
    for (int i = 0; i < system.n_free(); ++i)
      if (system.field[i] == Field::displacement && stiffness[i] > 0.)
        work[i] += 0.5 * std::pow(peak * push[i], 2) / stiffness[i];
  }
  const Layout layout = layout_of(system);
  return layout.sum(layout.counted(work).sum());
}

}  // namespace

Imbalance::Imbalance(Mismatch mismatch)
    : NumericsError(mismatch.what + " by " + significant(mismatch.value)), mismatch_(std::move(mismatch)) {}

void require_balance(double routes, const EnergyAccount& energy, double tolerable_routes) {
  require_no_gain(energy, energy.largest_work);
  const double off = energy.mismatch();
  const Mismatch of_forces{"both routes to the shear force differ", routes, tolerable_routes, routes,
                           routes <= bearable};
  const Mismatch of_energies{energies_differ, off, tolerable_energy, std::sqrt(off), off <= bearable};
  const bool forces_balance = routes <= tolerable_routes, energies_balance = off <= tolerable_energy;
  if (!energies_balance && (forces_balance || !of_energies.bearable || of_forces.bearable))
    throw Imbalance(of_energies);  // of two bearable mismatches that of energies means the larger error
  if (!forces_balance) throw Imbalance(of_forces);
}

void require_balance(const EnergyAccount& energy, const System& system, double end) {
  constexpr double round_off = 1e-10;
  const double possible = possible_work(system, end), work = energy.largest_work + round_off * possible;
  require_no_gain(energy, work);
  const double off = work > 0. ? energy.mismatch() * energy.largest_work / work : 0.;
  if (off <= tolerable_energy) return;
  const double of_possible = possible > 0. ? off * work / possible : 1.;
  throw Imbalance({energies_differ, off, tolerable_energy, std::sqrt(std::min(off, of_possible)),
                   off <= bearable || of_possible <= round_off});
}

}  // namespace upbead
