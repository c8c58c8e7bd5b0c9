#include "cli/respond_text.h"

#include <algorithm>

#include "base/text.h"
#include "output/output_text.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

std::string tables_of(const Json& waves, bool has_contact) {
  constexpr std::size_t longest_table = 20;  // rows that people read
  const std::vector<OutputRow> rows = rows_of_respond();
  std::string text;
  text += table_of(waves, rows, "waves[]",
                   {{"wave", "name"},
                    {"peak P", "peak_force"},
                    {"peak F_T", "peak_shear"},
                    {"F_T / P", "ratio"},
                    {"error of F_T", "error_estimate"},
                    {"S", "sliding"},
                    {"S, coupled", "sliding_coupled"},
                    {"lifted for", "coupled.lifted_time"}},
                   "", longest_table);
  const auto is_seaward = [](const Json& wave) {
    return -wave["peak_force_seaward"].get<double>() > wave["peak_force"].get<double>();
  };
  if (std::any_of(waves.begin(), waves.end(), is_seaward))
    text += table_of(waves, rows, "waves[]",
                     {{"seaward", "name"},
                      {"peak P", "peak_force_seaward"},
                      {"peak F_T", "peak_shear_seaward"},
                      {"F_T / P", "ratio"}},
                     "", longest_table);
  if (has_contact)
    text += table_of(waves, rows, "waves[]",
                     {{"node by node", "name"},
                      {"peak F_T", "response.peak_shear"},
                      {"S", "contact.solved.slip"},
                      {"error of S", "contact.solved.ground.slip"},
                      {"least contact", "contact.solved.least_contact"},
                      {"lift, seaward", "contact.solved.opening_seaward"},
                      {"landward", "contact.solved.opening_landward"}},
                     "", longest_table);
  const auto has_circle = [](const Json& wave) { return wave.contains("/circle/factor"_json_pointer); };
  if (std::any_of(waves.begin(), waves.end(), has_circle))
    text += table_of(waves, rows, "waves[]",
                     {{"least factor", "name"},
                      {"sliding", "least_sliding_factor"},
                      {"seaward", "least_sliding_factor_seaward"},
                      {"overturning", "least_overturning_margin"},
                      {"circles", "circle.factor"},
                      {"at", "circle.time"},
                      {"which slips", "circle.slips"},
                      {"by pressure", "circle.by"}},
                     "", longest_table);
  return text;
}

}  // namespace

std::string answers_text(const AnsweredModel& of, const Json& summary, const RespondTiming& timing) {
  const Json& waves = summary["waves"];
  const ReducedModelFile& model = of.model;
  std::string text = model.title + ", reduced to " + std::to_string(model.modes.n_modes()) + " modes: F_T within " +
                     significant(100. * model.error) + " % up to " + significant(model.highest_frequency) + " Hz\n";
  for (const auto& [key, value] : of.soil) text += "soil        " + key + " = " + number_text(value) + "\n";
  text += tables_of(waves, model.contact != nullptr);
  if (summary["not_judged"].is_string()) text += "not judged  " + summary["not_judged"].get<std::string>() + "\n";
  if (summary["why_void"].is_string())
    text += "verdict     VOID, as the warnings say: " + summary["why_void"].get<std::string>() + "\n";
  text += "time        read " + significant(timing.read) + " s, respond " + significant(timing.respond) + " s";
  if (timing.respond > 0.)
    text += " (" + significant(static_cast<double>(waves.size()) / timing.respond) + " waves a second)";
  return text + ", write " + significant(timing.write) + " s\n";
}

}  // namespace upbead
