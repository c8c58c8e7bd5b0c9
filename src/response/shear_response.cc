#include "response/shear_response.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/text.h"
#include "fem/caisson_readings.h"
#include "inside_steps.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

Extremum at_ends(const std::vector<double>& time, const Samples& values, int sign) {
  Eigen::Index at = 0;
  (sign * values).maxCoeff(&at);
  return {time[static_cast<std::size_t>(at)], values[at]};
}

/// Height of the resultant of all loads above the bottom at one time (m).
std::optional<double> arm_at(const CompiledScene& compiled, double time) {
  LoadOnCaisson total;
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
    const double f = compiled.system.loads[k].history(time);
    total.force_x += compiled.loads_on_caisson[k].force_x * f;
    total.moment += compiled.loads_on_caisson[k].moment * f;
  }
  return total.arm();
}

double largest(const Samples& values) {
  return values.cwiseAbs().maxCoeff();
}

/// `force`: largest |P|, which may lie between the times of the series.
double reaction_mismatch(const CompiledScene& compiled, const Series& balanced, double force) {
  const Samples by_ground = samples(compiled, balanced, reading::shear_force);
  const Samples by_inertia = samples(compiled, balanced, reading::shear_by_inertia);
  const auto of = [&](const char* name) { return largest(samples(compiled, balanced, name)); };
  const double other_forces = std::max({force, of(reading::normal_force), of(reading::uplift),
                                        of(reading::base_moment) / compiled.caisson->bottom_width});
  const double scale = std::max(largest(by_ground), 1e-6 * other_forces);
  return scale > 0. ? largest(by_ground - by_inertia) / scale : 0.;
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
  r.peak_displacement = inertia ? inside.displacement(1).value : of(reading::displacement_x).maxCoeff();
  r.peak_rotation = of(reading::rotation).maxCoeff();
  r.peak_base_moment = of(reading::base_moment).maxCoeff();
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

ShearResponse read_shear_response(const CompiledScene& compiled, const Response& response, bool inertia) {
  const TimeFunction P = force_on_caisson(compiled);
  const double end = response.ends.time.back();
  ShearResponse r;
  set_forces(r, P, end);
  set_peaks(r, compiled, response, P, inertia);
  set_ratios(r, end);
  r.arm = arm_at(compiled, is_seaward(r) ? r.peak_force_seaward_time : r.peak_force_time);
  r.reaction_mismatch = reaction_mismatch(compiled, response.balanced, std::max(r.peak_force, -r.peak_force_seaward));
  return r;
}

namespace {

constexpr double bearable = 1e-4;

/// generalised-alpha overshoots in steps much longer than the periods of a scene (Hilber and Hughes, Earthq. Eng.
/// Struct. Dyn. 6 (1978) 99), and more where short steps follow a pulse and long ones follow these.
void require_no_gain(const EnergyAccount& energy, double work) {
  constexpr double tolerable = 1.1;
  if (energy.stored() <= tolerable * work) return;
  std::ostringstream text;
  text
      << "the scene holds " << energy.stored() / work
      << " times the work of the loads, the rest of which the time scheme has made up: the steps are too long; shorten "
         "time.step, or leave it to the program: \"auto\"";
  throw NumericsError(text.str());
}

constexpr double tolerable_energy = 1e-6;
const std::string energies_differ = "the work of the loads and what became of it differ";

/// 1/2 sum of (peak b_i)^2 / K_ii, a measure of the work that the loads could do at rest if they acted alone; b of
/// a load that prescribes a pressure is that pressure's push.
double possible_work(const System& system, double end) {
  double work = 0.;
  for (const SystemLoad& load : system.loads) {
    const double peak = std::max(extremum(load.history, 0., end, 1).value, -extremum(load.history, 0., end, -1).value);
    for (int i = 0; i < system.n_free(); ++i) {
      const double push = load.prescribed < 0 ? load.vector[i] : system.C.coeff(i, load.prescribed);
      const double stiffness = std::abs(system.K.coeff(i, i));
      if (system.field[i] == Field::displacement && stiffness > 0.) work += 0.5 * std::pow(peak * push, 2) / stiffness;
    }
  }
  return work;
}

}  // namespace

Imbalance::Imbalance(Mismatch mismatch)
    : NumericsError(mismatch.what + " by " + significant(mismatch.value)), mismatch_(std::move(mismatch)) {}

void require_balance(const ShearResponse& shear, const EnergyAccount& energy) {
  constexpr double tolerable_routes = 1e-7;
  require_no_gain(energy, energy.largest_work);
  const double routes = shear.reaction_mismatch, off = energy.mismatch();
  const Mismatch of_forces{"both routes to the shear force differ", routes, tolerable_routes, routes,
                           routes <= bearable};
  const Mismatch of_energies{energies_differ, off, tolerable_energy, std::sqrt(off), off <= bearable};
  const bool forces_balance = routes <= tolerable_routes, energies_balance = off <= tolerable_energy;
  if (!energies_balance && (forces_balance || !of_energies.bearable || of_forces.bearable))
    throw Imbalance(of_energies);  // where both are bearable that of energies makes more wrong
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
