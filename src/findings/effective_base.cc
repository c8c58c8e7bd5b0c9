#include "findings/effective_base.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/run_end.h"
#include "fem/caisson/readings.h"
#include "fem/static_stage.h"
#include "run/sliding/uplift.h"

namespace upbead {

namespace {

/// Effective force and moment at rest on the ground.
struct RestingForces {
  double force = 0.;                   ///< W' (N/m)
  double moment = 0.;                  ///< about the bottom's middle, overturning landward positive (N m/m)
  double push = 0., push_moment = 0.;  ///< of still water at two levels; the moment is a part of that above
};

/// Weight minus the water that the caisson displaces; a cell that the level cuts displaces its part below it.
RestingForces submerged_weight(const Simulation& simulation, double level) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double middle = caisson.bottom_centre[0], g = simulation.scene().gravity;
  RestingForces rest{caisson.body.mass * g, caisson.body.mass * g * (caisson.body.centre[0] - middle)};
  for (const auto& cell : simulation.mesh()->triangulation.active_cell_iterators()) {
    if (simulation.mesh()->surface_of(cell) != caisson.body.region) continue;
    double low = cell->vertex(0)[1], high = low;
    for (const unsigned v : cell->vertex_indices()) {
      low = std::min(low, cell->vertex(v)[1]);
      high = std::max(high, cell->vertex(v)[1]);
    }
    const double wet = std::clamp((level - low) / (high - low), 0., 1.);
    const double lift = simulation.scene().fluid.density * g * wet * area_of(cell);
    rest.force -= lift;
    rest.moment -= lift * (cell->center()[0] - middle);
  }
  return rest;
}

/// In air where the scene gives no still water.
RestingForces weight_on_ground(const Simulation& simulation) {
  const double level = water_level(simulation.scene(), *simulation.mesh());
  return submerged_weight(simulation, std::isfinite(level) ? level : -1e300);
}

std::optional<RestingForces> at_rest(const Simulation& simulation) {
  const double level = water_level(simulation.scene(), *simulation.mesh());
  const auto& sliding = simulation.scene().sliding;
  if (!std::isfinite(level) && !sliding) return std::nullopt;
  RestingForces rest = weight_on_ground(simulation);
  if (sliding) {
    rest.moment *= sliding->submerged_weight / rest.force;
    rest.force = sliding->submerged_weight;
  }
  const Caisson& caisson = *simulation.compiled()->caisson;
  const StillWater still = still_water(simulation.scene(), caisson);
  rest.force += still.weight;
  rest.push = still.push;
  rest.push_moment = still.push_moment;
  rest.moment += still.push_moment + still.weight * caisson.bottom_width / 6.;  // B/6 landward of the middle
  return rest;
}

/// Adds what the sea in gaps presses with, which is straight between the ends of steps.
void add_gaps(const ContactHistory& contact, const std::vector<double>& time, double middle, EffectiveBase& base) {
  if (contact.gap_force.empty()) return;
  const TimeFunction force = piecewise_linear(contact.time, contact.gap_force),
                     moment_about_zero = piecewise_linear(contact.time, contact.gap_moment);
  const double end = contact.time.back();
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double F = until_end(force, time[i], end), M = until_end(moment_about_zero, time[i], end) + middle * F;
    base.uplift[i] += F;
    base.uplift_moment[i] += M;
    base.force[i] -= F;
    base.moment[i] += M;
  }
}

/// Loads that act up or down alone: they hold the caisson up, or lift it, as its weight and an uplift do.
void add_vertical(const CompiledScene& compiled, const std::vector<double>& time, EffectiveBase& base) {
  constexpr double upright = 1e-9;  // of a force: what its other part may be
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
    const LoadOnCaisson& load = compiled.loads_on_caisson[k];
    if (!(std::abs(load.force_x) <= upright * std::abs(load.force_y))) continue;
    if (load.force_y == 0.) continue;
    base.vertical.resize(time.size()), base.vertical_moment.resize(time.size());
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double f = load_in_row(compiled.system.loads[k].history, time, i);
      base.vertical[i] -= f * load.force_y;
      base.vertical_moment[i] += f * load.moment;
    }
  }
}

}  // namespace

double load_in_row(const TimeFunction& load, const std::vector<double>& time, std::size_t row) {
  return row > 0 ? load(time[row], 0.5 * (time[row - 1] + time[row])) : load(time[row]);
}

std::optional<double> weight_in_water(const Simulation& simulation) {
  const double level = water_level(simulation.scene(), *simulation.mesh());
  return std::isfinite(level) ? std::optional(submerged_weight(simulation, level).force) : std::nullopt;
}

std::optional<double> eccentricity_in_water(const Simulation& simulation) {
  const double level = water_level(simulation.scene(), *simulation.mesh());
  if (!std::isfinite(level)) return std::nullopt;
  const RestingForces rest = submerged_weight(simulation, level);
  return rest.force > 0. ? std::optional(rest.moment / rest.force) : std::nullopt;
}

std::optional<EffectiveBase> effective_base(const Simulation& simulation, const Series& ends,
                                            const std::optional<ContactSolution>& contact) {
  if (!simulation.compiled()->caisson) return std::nullopt;
  const std::optional<RestingForces> rest = at_rest(simulation);
  if (!rest || !(rest->force > 0.)) return std::nullopt;
  const System& system = simulation.system();
  const auto row = [&](const char* name) { return ends.reading.row(system.reading(name)); };
  const auto N = row(reading::normal_force), M = row(reading::base_moment), U = row(reading::uplift),
             M_U = row("uplift_moment");
  const std::vector<UpliftLoad> prescribed = uplift_loads(simulation, {}, {});
  EffectiveBase base;
  base.width = simulation.compiled()->caisson->bottom_width;
  base.weight = rest->force;
  base.weight_moment = rest->moment;
  base.push = rest->push;
  base.push_moment = rest->push_moment;
  for (std::size_t i = 0; i < ends.time.size(); ++i) {
    const auto t = static_cast<Eigen::Index>(i);
    double force = U[t], moment = M_U[t];
    for (const UpliftLoad& load : prescribed) {
      const double f = load_in_row(load.pressure, ends.time, i);
      force += load.force * f;
      moment += load.moment * f;
    }
    base.uplift.push_back(force);
    base.uplift_moment.push_back(moment);
    base.force.push_back(rest->force + N[t] - force);
    base.moment.push_back(rest->moment + M[t] + moment);
  }
  add_vertical(*simulation.compiled(), ends.time, base);
  if (contact && contact->history)
    add_gaps(*contact->history, ends.time, simulation.compiled()->caisson->bottom_centre[0], base);
  constexpr double round_off_of_weight = 1e-9;  // of a caisson that has left its ground
  for (double& force : base.force)
    if (std::abs(force) <= round_off_of_weight * base.weight) force = 0.;
  return base;
}

EffectiveBase loads_alone(const Simulation& simulation, EffectiveBase base, const Series& ends) {
  const auto& sliding = simulation.scene().sliding;
  const bool computed = sliding && sliding->uplift && sliding->uplift->kind == UpliftKind::computed;
  const System& system = simulation.system();
  for (std::size_t i = 0; i < ends.time.size() && !computed; ++i) {
    const auto t = static_cast<Eigen::Index>(i);
    base.uplift[i] -= ends.reading(system.reading(reading::uplift), t);
    base.uplift_moment[i] -= ends.reading(system.reading("uplift_moment"), t);
  }
  const CompiledScene& compiled = *simulation.compiled();
  for (std::size_t i = 0; i < ends.time.size(); ++i) {
    base.force[i] = base.weight - base.uplift[i];
    base.moment[i] = base.weight_moment + base.uplift_moment[i];
    for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
      const double f = load_in_row(compiled.system.loads[k].history, ends.time, i);
      base.force[i] -= f * compiled.loads_on_caisson[k].force_y;
      base.moment[i] += f * compiled.loads_on_caisson[k].moment;
    }
  }
  return base;
}

namespace {

Dataset of_edge(const std::string& name, const std::string& edge, std::vector<double> values) {
  Dataset data{
      name, "Pa",
      "effective pressure of the " + edge +
          " edge in motion, stress linear over the bottom; no number where the resultant leaves the base there",
      std::move(values)};
  data.may_lack = true;
  return data;
}

}  // namespace

std::vector<Dataset> base_histories(const EffectiveBase& base) {
  std::vector<double> eccentricity, toe, heel;
  for (std::size_t i = 0; i < base.force.size(); ++i) {
    eccentricity.push_back(base.force[i] > 0. ? base.moment[i] / base.force[i] : 0.);
    const EdgePressures edges = edge_pressures(base.force[i], base.moment[i], base.width);
    toe.push_back(edges.seaward.value_or(NAN));
    heel.push_back(edges.landward.value_or(NAN));
  }
  return {
      {"effective_normal_force", "N/m", "N' on the bottom, at rest and changed, compression positive", base.force},
      {"effective_base_moment", "N m/m", "M' about the bottom's middle, overturning landward positive", base.moment},
      {"eccentricity", "m", "M'/N', landward of the bottom's middle; 0 where N' is not positive", eccentricity},
      of_edge("toe_pressure", "seaward", std::move(toe)),
      of_edge("heel_pressure", "landward", std::move(heel))};
}

}  // namespace upbead
