#include "case_run.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "case/case_schema.h"
#include "case/cfd/flow_scene.h"
#include "case/key_units.h"
#include "case/records/record_layout.h"
#include "case/time_end.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "run/checks.h"
#include "run/histories.h"

namespace upbead {

namespace {

/// The resultant on the caisson; its moment is about the middle of the bottom.
Resultant on_caisson(const LoadSource& by, const Simulation& simulation) {
  const std::size_t n = by.gauges->time.size();
  Resultant sum{std::vector<double>(n, 0.), std::vector<double>(n, 0.)};
  for (const LoadOnCaisson& load : simulation.compiled->loads_on_caisson)
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

/// Warnings of all transducers (model/gauges.h).
NumberedWarnings transducer_warnings(const Case& input, const Simulation& simulation) {
  NumberedWarnings all;
  for (const auto& [name, by] : input.sources)
    if (by->gauges && by->acts()) {
      std::vector<double> force = on_caisson(*by, simulation).force;
      for (double& value : force) value /= by->load.factor;
      append(all, gauge_warnings(by->title, *by->gauges, force));
    }
  if (input.uplift && input.uplift->gauges)
    append(all, gauge_warnings(input.uplift->title, *input.uplift->gauges, on_bottom(*input.uplift).force));
  return all;
}

/// How the files of loads and uplift were read.
RecordNotes record_notes(const Case& input) {
  RecordNotes all;
  const auto add = [&all](const std::string& path, const LoadSource& source) {
    append(all, source.notes);
    for (std::size_t i = all.read.size() - source.notes.read.size(); i < all.read.size(); ++i) all.read[i].of = path;
  };
  for (const auto& [name, source] : input.sources) add(dotted("loads", name), *source);
  if (input.uplift) add(input.uplift->name, *input.uplift);
  return all;
}

/// Numbers whose unit was mistaken, as far as their key tells.
NumberedWarnings unit_warnings(const Case& input) {
  CaseTables tables = *input.tables;
  NumberedWarnings list = implausible_keys(
      input.document, [&](const NumberVisitor& visitor) { case_schema().visit_numbers(tables, "", visitor); });
  if (tables.section)
    append(list, implausible_section(*tables.section, {input.scene.fluid.density, input.scene.gravity}));
  return list;
}

NumberedWarnings warnings_of_files(const Case& input, const Simulation& simulation, const RecordNotes& notes) {
  NumberedWarnings list;
  for (const LoadSource* source : sources_of(input)) append(list, source->warnings);
  append(list, transducer_warnings(input, simulation));
  append(list, end_warnings(input, simulation.given.time.end));
  append(list, unit_warnings(input));
  append(list, flow_arm_warnings(input, *simulation.mesh));
  append(list, notes.warnings);
  return list;
}

std::vector<Skipped> left_out_of(const RecordNotes& notes) {
  std::vector<Skipped> list;
  for (const LeftOut& part : notes.left_out) list.push_back({part.what, part.why});
  return list;
}

/// The case's scene with what follows with the mesh: profiles, an end that is left to be chosen, pieces of its loads.
Scene scene_on(const Case& input, const Mesh& mesh) {
  Scene scene = with_profiles(input, mesh);
  if (end_is_open(input)) scene.time.end = settled_end(input, mesh).seconds;
  place_flows(input, mesh, scene);
  return scene;
}

}  // namespace

Simulation simulation_of(const Case& input, std::shared_ptr<const Mesh> mesh,
                         std::shared_ptr<const Processes> processes) {
  return in_places_of(input, [&] {
    check_size(input.scene);
    const Stopwatch watch;
    if (!mesh) mesh = read_mesh(mesh_request(input));
    const double seconds = watch.seconds();
    Scene scene = scene_on(input, *mesh);
    Simulation simulation(std::move(scene), std::move(mesh), std::move(processes));
    check_waves(input, simulation);
    simulation.timing.mesh += seconds;
    return simulation;
  });
}

std::vector<MeasuredRecord> read_records(const Case& input, const Simulation& simulation) {
  return input.tables->measured.empty() ? std::vector<MeasuredRecord>()
                                        : read_measured(input, names_of_histories(simulation));
}

namespace {

/// Adds what is said of the case's files.
Run with_files(const Case& input, const std::vector<MeasuredRecord>& records, Run run) {
  Summary& summary = run.summary;
  const RecordNotes notes = record_notes(input);
  summary.gauges = gauge_summaries(input, *run.simulation);
  summary.flows = flow_summaries(input);
  summary.waves = wave_summaries(input);
  summary.formula_checks = formula_checks(summary.waves, input.scene.limits);
  append(summary.warnings, warnings_of_files(input, *run.simulation, notes));
  judge(input.scene, summary);
  append(summary.skipped, left_out_of(notes));
  if (records.empty()) return run;
  summary.measured = compare_measured(input, records, histories(*run.simulation, run.response.ends));
  for (const MeasuredRecord& record : records) {
    append(summary.skipped, left_out_of(record.notes));
    append(summary.warnings, record.notes.warnings);
  }
  return run;
}

}  // namespace

Run solve(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& records,
          const RunOptions& options) {
  return with_files(input, records, in_places_of(input, [&] { return simulation.run(options); }));
}

Run answer(const Case& input, const SolvedScene& solved, const std::function<void(double)>& progress) {
  Run run = in_places_of(input, [&] { return solved.run(scene_on(input, solved.given_mesh()), progress); });
  const std::vector<MeasuredRecord> records = read_records(input, *run.simulation);
  return with_files(input, records, std::move(run));
}

NumberedWarnings warnings(const Case& input, const Simulation& simulation) {
  NumberedWarnings list = warnings(simulation);
  append(list, warnings_of_files(input, simulation, record_notes(input)));
  return list;
}

std::vector<Skipped> skipped(const Case& input, const Simulation& simulation, bool reduced) {
  std::vector<Skipped> list = skipped(simulation, reduced);
  append(list, left_out_of(record_notes(input)));
  return list;
}

std::vector<RecordSummary> record_summaries(const Case& input, const std::vector<MeasuredRecord>& records) {
  std::vector<RecordSummary> list = record_notes(input).read;
  for (const MeasuredRecord& record : records) append(list, record.notes.read);
  return list;
}

std::vector<GaugeSummary> gauge_summaries(const Case& input, const Simulation& simulation) {
  std::vector<GaugeSummary> list;
  for (const auto& [name, by] : input.sources)
    if (by->gauges) list.push_back(summary_of(*by, on_caisson(*by, simulation)));
  if (input.uplift && input.uplift->gauges) list.push_back(summary_of(*input.uplift, on_bottom(*input.uplift)));
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
