#include "case_run.h"

#include "base/stopwatch.h"
#include "case_warnings.h"
#include "records/gauge_report.h"
#include "records/record_notes.h"
#include "run/histories.h"

namespace upbead {

namespace {

template <class Item>
void append(std::vector<Item>& list, const std::vector<Item>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

NumberedWarnings warnings_of_files(const Case& input, const Simulation& simulation, const RecordNotes& notes) {
  NumberedWarnings list = history_warnings(input);
  append(list, gauge_warnings(input, simulation));
  append(list, zero_load_warnings(input));
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
    Simulation simulation(input.scene, std::move(mesh), std::move(processes));
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
  append(summary.warnings, warnings_of_files(input, *run.simulation, notes));
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

}  // namespace upbead
