// What transducers along a wall or a bottom measured.
#include <cmath>

#include "base/numbers.h"
#include "case/case_run.h"
#include "case/load_source.h"
#include "fem/compile.h"

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
    }
  if (input.uplift && input.uplift->gauges)
    append(all, gauge_warnings(input.uplift->title, *input.uplift->gauges, on_bottom(*input.uplift).force, end));
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
