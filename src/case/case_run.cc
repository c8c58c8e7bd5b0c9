#include "case_run.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "case/case_schema.h"
#include "case/cfd/flow_scene.h"
#include "case/key_units.h"
#include "case/records/load_records.h"
#include "case/records/record_layout.h"
#include "case/records/record_table.h"
#include "case/time_end.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "model/record.h"
#include "run/checks.h"
#include "run/histories.h"

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

/// How the files of loads and uplift were read.
RecordNotes record_notes(const Case& input) {
  RecordNotes all;
  for (const auto& [path, notes] : input.records) {
    append(all, *notes);
    for (std::size_t i = all.read.size() - notes->read.size(); i < all.read.size(); ++i) all.read[i].of = path;
  }
  return all;
}

Record record_of(const std::string& name, const TimeFunction& f) {
  Record record{name, f.samples(), {}};
  for (const double t : record.time) record.value.push_back(f(t, t == record.time.back() ? t - 1e-12 * t : t));
  return record;
}

/// Warnings of all histories that come from files (model/record.h).
NumberedWarnings history_warnings(const Case& input) {
  NumberedWarnings all;
  const auto add = [&all](const std::string& name, const TimeFunction& f) {
    if (f.samples().size() < 2) return;
    append(all, record_warnings(record_of(name, f)));
  };
  for (const auto& [name, source] : input.sources) {
    const Load& load = input.scene.loads.at(name);
    if (source.history.empty() || load.factor == 0.) continue;
    const std::string path = "loads." + name;
    if (is_motion(load.kind))  // the scene has its velocity
      append(all, record_warnings(written_history(path, input.resolve(source.history), input.place(path + ".history"),
                                                  load.kind, source.record_start)));
    else
      add(path, load.history);
  }
  if (!input.uplift_history.empty()) add("sliding.uplift", input.scene.sliding->uplift->history);
  return all;
}

/// Numbers whose unit was mistaken, as far as their key tells.
NumberedWarnings unit_warnings(const Case& input) {
  CaseTables tables;
  Diagnostics none;
  const TableSchema<CaseTables> schema = case_schema();
  schema.read(input.document.root(), "", tables, none);
  NumberedWarnings list = implausible_keys(
      input.document, [&](const NumberVisitor& visitor) { schema.visit_numbers(tables, "", visitor); });
  if (input.section)
    append(list, implausible_section(*input.section, {input.scene.fluid.density, input.scene.gravity}));
  return list;
}

NumberedWarnings warnings_of_files(const Case& input, const Simulation& simulation, const RecordNotes& notes) {
  NumberedWarnings list = history_warnings(input);
  append(list, transducer_warnings(input, simulation));
  append(list, end_warnings(input, simulation.given.time.end));
  append(list, unit_warnings(input));
  append(list, wave_warnings(input));
  append(list, flow_warnings(input));
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
  return input.measured.empty() ? std::vector<MeasuredRecord>() : read_measured(input, names_of_histories(simulation));
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
