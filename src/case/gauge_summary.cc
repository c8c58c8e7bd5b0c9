// What transducers along a wall or a bottom measured.
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "case/case_run.h"
#include "case/case_schema.h"
#include "case/load_source.h"
#include "fem/compile.h"
#include "fem/static_stage.h"

namespace upbead {

namespace {

/// The resultant on the caisson; its moment is about the middle of the bottom.
Resultant on_caisson(const LoadSource& by, const Simulation& simulation) {
  const std::size_t n = by.gauges->time.size();
  Resultant sum{std::vector<double>(n, 0.), std::vector<double>(n, 0.)};
  for (const LoadOnCaisson& load : simulation.compiled()->loads_on_caisson)
    for (std::size_t i = 0; i < by.gauges->count(); ++i) {
      if (load.name != by.name + "." + by.gauges->name[i]) continue;
      for (std::size_t t = 0; t < n; ++t) {
        sum.force[t] += by.load.factor * load.force_x * by.gauges->pressure[i][t];
        sum.moment[t] += by.load.factor * load.moment * by.gauges->pressure[i][t];
      }
    }
  return sum;
}

/// The resultant of an uplift; its moment is about the middle of the bottom.
Resultant on_bottom(const LoadSource& by) {
  const auto [from, to] = by.gauges->zero_at;
  Resultant sum = resultant(*by.gauges, from, to);
  for (std::size_t t = 0; t < sum.force.size(); ++t) sum.moment[t] -= 0.5 * (from + to) * sum.force[t];
  return sum;
}

GaugeSummary summary_of(const LoadSource& by, const Resultant& sum) {
  const Gauges& gauges = *by.gauges;
  GaugeSummary s;
  s.name = by.name;
  s.gauges = static_cast<int>(gauges.count());
  s.samples = static_cast<int>(gauges.time.size());
  s.interval = (gauges.time.back() - gauges.time.front()) / static_cast<double>(gauges.time.size() - 1);
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    const std::size_t t = index_of_largest(gauges.pressure[i]);
    if (std::abs(gauges.pressure[i][t]) <= std::abs(s.peak_pressure)) continue;
    s.peak_gauge = gauges.name[i];
    s.peak_pressure = gauges.pressure[i][t];
    s.peak_at = gauges.place[i];
    s.peak_pressure_time = gauges.time[t];
  }
  const std::size_t t = index_of_largest(sum.force);
  s.peak_force = sum.force[t];
  s.peak_force_time = gauges.time[t];
  const double row = gauges.place.back() - gauges.place.front();
  if (std::abs(s.peak_force) > 1e-9 * std::abs(s.peak_pressure * by.load.factor) * row)
    s.arm = sum.moment[t] / sum.force[t];
  const InterpolationError error = interpolation_error(gauges);
  s.force_error = error.force;
  s.arm_error = error.arm;
  if (!gauges.load_cell.empty()) s.load_cell = gauges.load_cell[index_of_largest(gauges.load_cell)];
  return s;
}

/// Height up to which still water may stand at a wall, as far as is known: else its highest transducer (m).
double still_level(const Case& input, const Gauges& gauges, const Simulation& simulation) {
  const double level = water_level(simulation.given(), *simulation.mesh());
  if (std::isfinite(level)) return level;
  const auto& caisson = simulation.compiled()->caisson;
  if (input.tables->section && caisson) return caisson->bottom_centre[1] + input.tables->section->foundation_depth;
  return gauges.place.back();
}

/// Warning suction: water pulls no more at a wall than it had pressed at rest, rho g times its depth.
NumberedWarnings warnings_of_suction(const Case& input, const LoadSource& by, const Simulation& simulation) {
  constexpr double tolerable = 0.2;  // of the largest pressure, as of air that swings behind a breaker
  const Gauges& gauges = *by.gauges;
  if (gauges.over_x) return {};
  const Scene& scene = simulation.given();
  const double level = still_level(input, gauges, simulation), factor = by.load.factor;
  double largest = 0., beyond = 0.;
  NumberedWarning worst{"suction", 0., 0., "Pa", "", "give pressures on the wall as positive", true};
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    const auto [least, most] = std::minmax_element(gauges.pressure[i].begin(), gauges.pressure[i].end());
    const double p = std::min(factor * *least, factor * *most),
                 at_rest = scene.fluid.density * scene.gravity * std::max(level - gauges.place[i], 0.);
    largest = std::max({largest, std::abs(factor * *least), std::abs(factor * *most)});
    if (-p - at_rest <= beyond) continue;
    beyond = -p - at_rest;
    worst.value = p;
    worst.limit = -at_rest;
    worst.what = by.title + "." + gauges.name[i] + " is " + with_unit(p, "Pa") +
                 ", and a wave that leaves the wall takes away no more than still water, " + with_unit(at_rest, "Pa");
  }
  if (beyond > tolerable * largest) return {worst};
  return {};
}

/// Warning uplift_ends: the row is not as long as the bottom that it lifts.
NumberedWarnings warnings_of_ends(const LoadSource& uplift, const Simulation& simulation) {
  constexpr double same = 0.02;  // of the bottom
  const auto& caisson = simulation.compiled()->caisson;
  if (!caisson) return {};
  const double B = caisson->bottom_width, seaward = caisson->bottom_centre[0] - 0.5 * B;
  const auto [from, to] = uplift.gauges->zero_at;
  const double apart = std::max(std::abs(from - seaward), std::abs(to - seaward - B));
  if (apart <= same * B) return {};
  return {{"uplift_ends", apart, same * B, "m",
           uplift.title + ": ends = [" + significant(from, 4) + ", " + significant(to, 4) +
               "], and the caisson's bottom goes from x = " + significant(seaward, 4) + " to " +
               significant(seaward + B, 4) + " m: U is that of another bottom",
           "give the positions and ends in the x of the mesh", true}};
}

}  // namespace

/// Warnings of all transducers (model/gauges.h).
NumberedWarnings transducer_warnings(const Case& input, const Simulation& simulation) {
  NumberedWarnings all;
  const double end = simulation.given().time.end;
  for (const auto& [name, by] : input.sources)
    if (by->gauges && by->acts()) {
      std::vector<double> force = on_caisson(*by, simulation).force;
      for (double& value : force) value /= by->load.factor;
      append(all, gauge_warnings(by->title, *by->gauges, force, end));
      append(all, warnings_of_suction(input, *by, simulation));
    }
  if (input.uplift && input.uplift->gauges) {
    append(all, gauge_warnings(input.uplift->title, *input.uplift->gauges, on_bottom(*input.uplift).force, end));
    append(all, warnings_of_ends(*input.uplift, simulation));
  }
  return all;
}

std::vector<GaugeSummary> gauge_summaries(const Case& input, const Simulation& simulation) {
  std::vector<GaugeSummary> list;
  for (const auto& [name, by] : input.sources)
    if (by->gauges) list.push_back(summary_of(*by, on_caisson(*by, simulation)));
  if (input.uplift && input.uplift->gauges) list.push_back(summary_of(*input.uplift, on_bottom(*input.uplift)));
  return list;
}

OutputSchema<GaugeSummary> gauge_outputs() {
  using G = GaugeSummary;
  return OutputSchema<G>()
      .key("gauges", &G::gauges, "", "how many")
      .key("samples", &G::samples, "", "how many")
      .key("interval", &G::interval, "s", "between samples, mean")
      .key("peak_gauge", &G::peak_gauge, "", "transducer with the largest pressure")
      .key("peak_pressure", &G::peak_pressure, "Pa", "largest pressure")
      .key("peak_pressure_time", &G::peak_pressure_time, "s", "when")
      .key("peak_pressure_at", &G::peak_at, "m", "where")
      .key("peak_force", &G::peak_force, "N/m", "largest force")
      .key("peak_force_time", &G::peak_force_time, "s", "when")
      .key("arm", &G::arm, "m",
           "height of the largest force above the bottom; for an uplift its distance landward of the bottom's middle")
      .key("force_error", &G::force_error, "", "relative error of the force by interpolation")
      .key("arm_error", &G::arm_error, "", "error of the arm by interpolation, over the row's length")
      .key("load_cell", &G::load_cell, "N/m", "largest force by the load cell; null without");
}

}  // namespace upbead
