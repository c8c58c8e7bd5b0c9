#include "case_run.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "case/cfd/flow_scene.h"
#include "case/records/record_layout.h"
#include "case/records/record_table.h"
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
  if (s.peak_force != 0.) s.arm = sum.moment[t] / sum.force[t];
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

/// Notes the columns of values that a history does not use: it uses only the first.
void note_further_values(const CsvTable& table, const RecordLayout& layout, RecordNotes& notes) {
  if (layout.values.size() < 2) return;
  std::string what = column_text(table, layout.values[1]);
  if (layout.values.size() > 2) what += " and " + std::to_string(layout.values.size() - 2) + " more";
  notes.left_out.push_back({what, "a history has one value, here " + in_quotes(table.names[layout.values[0]])});
}

void note_history(const Case& input, const std::string& file, RecordNotes& notes) {
  if (file.empty()) return;
  const CsvTable table = read_record_head(input.resolve(file));
  const RecordLayout layout = layout_of(table);
  note_layout(table, layout, notes);
  note_further_values(table, layout, notes);
}

void note_gauges(const Case& input, const GaugeSource& source, RecordNotes& notes) {
  if (source.gauges.empty()) return;  // such a load comes from a record of CFD
  const CsvTable table = read_record_head(input.resolve(source.gauges));
  RecordLayout layout = layout_of(table);
  if (source.sampling_rate) layout.time.reset();
  note_layout(table, layout, notes);
}

/// What is not used of the files of loads and uplift (counters, further columns of a history), and what may be read
/// wrongly. Only the beginning of each file is read again: the whole of a long record would take as long as the first
/// time.
RecordNotes record_notes(const Case& input) {
  RecordNotes notes;
  for (const auto& [name, source] : input.sources) note_history(input, source.history, notes);
  for (const auto& [name, by] : input.gauges) note_gauges(input, by.source, notes);
  note_history(input, input.uplift_history, notes);
  if (input.uplift_gauges) note_gauges(input, input.uplift_gauges->source, notes);
  return notes;
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
  for (const auto& [name, source] : input.sources)
    if (const Load& load = input.scene.loads.at(name); !source.history.empty() && load.factor != 0.)
      add("loads." + name, load.history);
  if (!input.uplift_history.empty()) add("sliding.uplift", input.scene.sliding->uplift->history);
  return all;
}

/// First time at which a function of time is not zero, looked for at its samples and kinks; none where it is always
/// zero.
std::optional<double> first_action(const TimeFunction& f) {
  std::vector<double> times = f.samples().empty() ? f.kinks() : f.samples();
  const std::vector<double>& kinks = f.kinks();
  for (std::size_t i = 0; f.samples().empty() && i + 1 < kinks.size(); ++i)
    times.push_back(0.5 * (kinks[i] + kinks[i + 1]));  // a pulse is smooth between its kinks
  std::sort(times.begin(), times.end());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double before = i > 0 ? times[i - 1] : times[i] - 1.;
    if (f(times[i]) != 0. || f(times[i], 0.5 * (before + times[i])) != 0.) return before;
  }
  return f(kinks.empty() ? 0. : kinks.back() + 1.) != 0. ? std::optional(0.) : std::nullopt;
}

NumberedWarning zero_load(const std::string& name, const std::optional<double>& from, double end) {
  const std::string when = from ? "is zero until t = " + significant(*from, 4) + " s, after the end of the run at " +
                                      significant(end, 4) + " s"
                                : "is zero throughout";
  return {"load_zero", from.value_or(end), end, "s",
          "'" + name + "' " + when +
              ": nothing of it is felt; look at its columns and units, at record_start, or give a longer time.end"};
}

/// Time (s) at which the first of the transducers has a pressure.
std::optional<double> first_action(const Gauges& gauges) {
  for (std::size_t t = 0; t < gauges.time.size(); ++t)
    for (const std::vector<double>& pressure : gauges.pressure)
      if (pressure[t] != 0.) return t > 0 ? gauges.time[t - 1] : gauges.time[t];
  return std::nullopt;
}

/// load_zero: a load or uplift that is zero within the run, as where a wrong column was read.
NumberedWarnings zero_load_warnings(const Case& input) {
  NumberedWarnings list;
  const double end = input.scene.time.end;
  const auto look = [&](const std::string& name, const std::optional<double>& from) {
    if (!from || *from >= end) list.push_back(zero_load(name, from, end));
  };
  for (const auto& [name, source] : input.sources)
    if (const Load& load = input.scene.loads.at(name); load.factor != 0.)
      look("loads." + name, first_action(load.history));
  for (const auto& [name, by] : input.gauges)
    if (by.load.factor != 0.) look("loads." + name, first_action(by.gauges));
  if (!input.uplift_history.empty()) look("sliding.uplift", first_action(input.scene.sliding->uplift->history));
  return list;
}

NumberedWarnings warnings_of_files(const Case& input, const Simulation& simulation, const RecordNotes& notes) {
  NumberedWarnings list = history_warnings(input);
  append(list, transducer_warnings(input, simulation));
  append(list, zero_load_warnings(input));
  append(list, wave_warnings(input));
  append(list, flow_warnings(input));
  append(list, notes.warnings);
  return list;
}

std::vector<Skipped> left_out_of(const RecordNotes& notes) {
  std::vector<Skipped> list;
  for (const LeftOut& part : notes.left_out) list.push_back({part.what, part.why});
  return list;
}

}  // namespace

Simulation simulation_of(const Case& input, std::shared_ptr<const Mesh> mesh,
                         std::shared_ptr<const Processes> processes) {
  return in_places_of(input, [&] {
    check_size(input.scene);
    const Stopwatch watch;
    if (!mesh) mesh = read_mesh(mesh_request(input));
    const double seconds = watch.seconds();
    Scene scene = with_profiles(input, *mesh);
    place_flows(input, *mesh, scene);
    Simulation simulation(scene, std::move(mesh), std::move(processes));
    check_waves(input, simulation);
    simulation.timing.mesh += seconds;
    return simulation;
  });
}

std::vector<MeasuredRecord> read_records(const Case& input, const Simulation& simulation) {
  return input.measured.empty() ? std::vector<MeasuredRecord>() : read_measured(input, names_of_histories(simulation));
}

Run solve(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& records,
          const RunOptions& options) {
  Run run = in_places_of(input, [&] { return simulation.run(options); });
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
