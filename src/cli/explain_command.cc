#include <iostream>

#include "case/case_findings.h"
#include "case/case_run.h"
#include "case/script_trust.h"
#include "cli/command.h"
#include "cli/known_warnings.h"
#include "cli/report.h"
#include "design/calibrate/calibration_report.h"
#include "design/expected_report.h"
#include "design/sheet.h"
#include "design/waves_report.h"
#include "findings/topics.h"
#include "model/exclusions.h"
#include "output/wave_response.h"
#include "reliability/answer.h"
#include "reliability/indices.h"

namespace upbead {

namespace {

/// The keys of every summary, by command.
std::vector<std::pair<std::string, std::vector<OutputRow>>> outputs() {
  return {{"run", summary_outputs().rows()},    {"explain", rows_of_explain()},
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
  std::cout << (options.json ? explanation(input, simulation, measured, told).dump(2) + "\n"
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
      {"--warnings", "print every warning with its number, its limit and who gives it", warning_reference},
      {"--exclusions", "print what cannot go with what", exclusion_table}};
  command.work = [options] { return explain(*options); };
  return command;
}

}  // namespace upbead
