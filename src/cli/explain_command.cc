#include <iostream>

#include "case/case_findings.h"
#include "case/case_run.h"
#include "case/cfd/flow_scene.h"
#include "case/script_trust.h"
#include "case/wave_load.h"
#include "cli/command.h"
#include "cli/report.h"
#include "design/calibrate/calibration_report.h"
#include "design/expected_report.h"
#include "design/sheet.h"
#include "design/waves_report.h"
#include "fem/compile.h"
#include "findings/topics.h"
#include "model/exclusions.h"
#include "output/wave_response.h"
#include "reliability/answer.h"
#include "reliability/indices.h"
#include "response/time_choice.h"
#include "run/yielding_extent.h"

namespace upbead {

namespace {

bool will_be_reduced(const Simulation& simulation) {
  return choose_scheme(simulation.scene(), *simulation.compiled()).scheme == TimeScheme::reduced;
}

/// All that `explain` prints.
struct Explained {
  const Case* input;
  const Simulation* simulation;
  NumberedWarnings told;
  std::vector<RecordSummary> records;
  std::vector<GaugeSummary> gauges;
  std::vector<FlowSummary> flows;
  std::vector<WaveLoadSummary> waves;
  std::vector<Skipped> skipped;
  YieldingExtent yielding;
};

/// What was chosen for each region, and why.
Json regions(const Explained& e) {
  Json json = Json::object();
  for (const Decision& decision : e.simulation->decisions())
    if (!decision.region.empty()) json[decision.region] = {{decision.key, decision.value}, {"why", decision.why}};
  return json;
}

OutputSchema<RecordSummary> record_outputs() {
  using R = RecordSummary;
  return OutputSchema<R>()
      .key("of", &R::of, "", "key of the case that it belongs to")
      .key("file", &R::file, "", "its file")
      .key("column", &R::column, "", "its column")
      .key("unit", &R::unit, "", "unit that was taken, and how it is known where not by the header")
      .key("layout", &R::layout, "", "separator, decimal sign and header of the file")
      .key("samples", &R::samples, "", "how many")
      .key("begin", &R::begin, "s", "first time, in the run's time")
      .key("interval", &R::interval, "s", "between samples, mean")
      .key("extreme", &R::extreme, "", "largest value by magnitude, as the file has it")
      .key("extreme_time", &R::extreme_time, "s", "when, in the run's time")
      .key("extreme_unit", &R::si, "", "SI unit of `extreme`");
}

const OutputSchema<Explained>& explained_outputs() {
  using E = Explained;
  const auto size =
      OutputSchema<Simulation>()
          .key(
              "cells", [](const Simulation& s) { return s.mesh()->triangulation.n_active_cells(); }, "", "cells")
          .key(
              "unknowns", [](const Simulation& s) { return s.system().n_free(); }, "", "unknowns")
          .key("degree", inner(&Simulation::space, &Space::degree), "", "degree of the displacement");
  const auto yielding =
      OutputSchema<YieldingExtent>()
          .key("cells", &YieldingExtent::cells, "", "cells that may yield")
          .key("area", &YieldingExtent::area, "m2", "of them")
          .list("linear[]", &YieldingExtent::linear, skipped_outputs(), "each region that is linear, and why");
  static const auto schema =
      OutputSchema<E>()
          .key("title", inner(&E::input, &Case::scene, &Scene::title), "", "that of the case")
          .object("discretisation", &E::simulation, size, "how the scene would be solved")
          .key("regions.NAME", regions, "", "`flow` or `kind` as chosen, and `why`")
          .named(
              "loads.NAME", [](const E& e) -> auto& { return e.simulation->compiled()->loads_on_caisson; },
              &LoadOnCaisson::name, load_outputs(), "resultant on the caisson per unit of the history")
          .named("flows.NAME", &E::flows, &FlowSummary::name, flow_outputs(), "of a load [from a CFD program](cfd.md)")
          .list("records[]", &E::records, record_outputs(), "how each column of the [files](records.md) was read")
          .named("gauges.NAME", &E::gauges, &GaugeSummary::name, gauge_outputs(),
                 "of a load by [transducers](records.md), or `sliding.uplift`")
          .named("wave_loads.NAME", &E::waves, &WaveLoadSummary::name, wave_load_outputs(),
                 "of a load by a [wave](waves.md#a-wave-as-a-load-of-a-run)")
          .object("yielding", &E::yielding, yielding, "[soil that yields](yielding.md)")
          .list("skipped[]", &E::skipped, skipped_outputs(), "what would be left out")
          .list("warnings[]", &E::told, warning_outputs(), "[what may be wrong](warnings.md) and needs no solution");
  return schema;
}

std::string explanation_json(const Case& input, const Simulation& simulation, const NumberedWarnings& told,
                             const std::vector<RecordSummary>& records) {
  const Explained explained{&input,
                            &simulation,
                            told,
                            records,
                            gauge_summaries(input, simulation),
                            flow_summaries(input),
                            wave_summaries(input),
                            skipped(input, simulation, will_be_reduced(simulation)),
                            yielding_extent(simulation)};
  return explained_outputs().to_json(explained).dump(2) + "\n";
}

/// The keys of every summary, by command.
std::vector<std::pair<std::string, std::vector<OutputRow>>> outputs() {
  return {{"run", summary_outputs().rows()},    {"explain", explained_outputs().rows()},
          {"sheet", rows_of_sheet()},           {"respond", rows_of_respond()},
          {"waves", rows_of_waves()},           {"expected", rows_of_expected()},
          {"calibrate", rows_of_calibration()}, {"reliability", rows_of_reliability()},
          {"indices", rows_of_indices()}};
}

std::string output_reference() {
  std::string text;
  for (const auto& [command, rows] : outputs())
    text += std::string(text.empty() ? "" : "\n") + "## summary.json of `upbead " + command + "`\n\n" + markdown(rows);
  return text;
}

std::string output_table() {
  Json json;
  for (const auto& [command, rows] : outputs())
    for (const OutputRow& row : rows) json[command][row.path] = {row.unit, row.meaning};
  return json_text(json);
}

int explain(const CaseOptions& options) {
  Case input = read_case(options.file, options.overrides);
  require_trust(input, options.trusted);
  const Simulation simulation = simulation_of(input, settle_end(input));
  const NumberedWarnings told = warnings(input, simulation);
  std::cerr << notes_on(input) << describe(told);
  const std::vector<MeasuredRecord> measured = read_records(input, simulation);
  std::cout << (options.json ? explanation_json(input, simulation, told, record_summaries(input, measured))
                             : details(input, simulation, measured));
  return 0;
}

}  // namespace

Command explain_command() {
  const auto options = std::make_shared<CaseOptions>();
  Command command = case_command("explain", *options);
  command.texts = {
      {"--keys", "print every key of a case file with unit, range, default and meaning", case_reference},
      {"--schema", "print them as JSON Schema, by which an editor completes and checks a case file", case_json_schema},
      {"--outputs", "print every key of the summaries with unit and meaning", output_reference},
      {"--outputs-json", "the same for programs", output_table},
      {"--exclusions", "print what cannot go with what", exclusion_table}};
  command.work = [options] { return explain(*options); };
  return command;
}

}  // namespace upbead
