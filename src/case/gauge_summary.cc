// What transducers along a wall or a bottom measured.
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "case/case_run.h"
#include "fem/compile.h"

namespace upbead {

namespace {

/// The resultant on the caisson; its moment is about the middle of the bottom.
Resultant on_caisson(const std::string& name, const GaugeLoad& by, const Simulation& simulation) {
  const std::size_t n = by.gauges.time.size();
  Resultant sum{std::vector<double>(n, 0.), std::vector<double>(n, 0.)};
  for (const LoadOnCaisson& load : simulation.compiled->loads_on_caisson)
    for (std::size_t i = 0; i < by.gauges.count(); ++i) {
      if (load.name != name + "." + by.gauges.name[i]) continue;
      for (std::size_t t = 0; t < n; ++t) {
        sum.force[t] += by.load.factor * load.force_x * by.gauges.pressure[i][t];
        sum.moment[t] += by.load.factor * load.moment * by.gauges.pressure[i][t];
      }
    }
  return sum;
}

/// The resultant of an uplift; its moment is about the middle of the bottom.
Resultant on_bottom(const GaugeLoad& by) {
  const auto [from, to] = *by.source.ends;
  Resultant sum = resultant(by.gauges, from, to);
  for (std::size_t t = 0; t < sum.force.size(); ++t) sum.moment[t] -= 0.5 * (from + to) * sum.force[t];
  return sum;
}

GaugeSummary summary_of(const std::string& name, const GaugeLoad& by, const Resultant& sum) {
  const Gauges& gauges = by.gauges;
  GaugeSummary s;
  s.name = name;
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
  for (const auto& [name, by] : input.gauges)
    if (by.load.factor != 0.) {
      std::vector<double> force = on_caisson(name, by, simulation).force;
      for (double& value : force) value /= by.load.factor;
      append(all, gauge_warnings("loads." + name, by.gauges, force));
    }
  if (input.uplift_gauges)
    append(all, gauge_warnings("sliding.uplift", input.uplift_gauges->gauges, on_bottom(*input.uplift_gauges).force));
  return all;
}

std::vector<GaugeSummary> gauge_summaries(const Case& input, const Simulation& simulation) {
  std::vector<GaugeSummary> list;
  for (const auto& [name, by] : input.gauges) list.push_back(summary_of(name, by, on_caisson(name, by, simulation)));
  if (input.uplift_gauges)
    list.push_back(summary_of("sliding.uplift", *input.uplift_gauges, on_bottom(*input.uplift_gauges)));
  return list;
}

std::string describe(const std::vector<GaugeSummary>& gauges) {
  std::string text;
  for (const GaugeSummary& g : gauges) {
    text += "gauges      " + g.name + ": " + std::to_string(g.gauges) + " transducers, " + std::to_string(g.samples) +
            " samples every " + significant(g.interval) + " s; most at " + g.peak_gauge + " (" +
            significant(g.peak_at) + " m): " + with_unit(g.peak_pressure, "Pa") + " at " +
            significant(g.peak_pressure_time, 4) + " s\n";
    text += "            largest force " + with_unit(g.peak_force, "N/m") + " at " + significant(g.peak_force_time, 4) +
            " s";
    if (g.arm) text += ", arm " + significant(*g.arm, 4) + " m";
    text += "; between transducers it may err by " + significant(100. * g.force_error, 2) + " %";
    if (g.load_cell) text += "; by the load cell " + with_unit(*g.load_cell, "N/m");
    text += "\n";
  }
  return text;
}

}  // namespace upbead
