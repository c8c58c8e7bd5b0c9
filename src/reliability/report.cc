#include <algorithm>
#include <cstdio>

#include "base/text.h"
#include "reliability/answer.h"
#include "reliability/text_columns.h"

namespace upbead {

namespace {

std::string cell(const std::optional<double>& value, int digits = 3) {
  return value ? significant(*value, digits) : "-";
}

TextRow chances_row(const ModeAnswer& mode) {
  return {mode.name,
          cell(mode.occasion.probability),
          cell(mode.year.probability),
          cell(mode.life.probability),
          cell(mode.occasion.index),
          cell(mode.life.index),
          mode.governing.empty() ? "-" : mode.governing};
}

/// beta by each method, with the coefficient of variation of sampled probabilities.
std::string methods_table(const ReliabilityAnswer& answer) {
  std::vector<TextRow> rows{{"mode"}};
  for (const ModeAnswer& mode : answer.modes) {
    if (mode.methods.empty()) continue;
    TextRow row{mode.name};
    for (const std::string& method : reliability_methods)
      for (const MethodAnswer& found : mode.methods)
        if (found.method == method)
          row.push_back(cell(found.index, 4) +
                        (found.variation ? " (" + significant(100. * *found.variation, 2) + " %)" : ""));
    if (mode.is_system && row.size() < rows.front().size() && rows.front()[2] == "sorm")
      row.insert(row.begin() + 2, "-");
    if (rows.front().size() == 1)
      for (const MethodAnswer& found : mode.methods) rows.front().push_back(found.method);
    rows.push_back(row);
  }
  return "\nIndex beta of an occasion by each method (coefficient of variation of the probability)\n" + columns(rows);
}

std::string point_table(const ModeAnswer& mode) {
  std::vector<TextRow> rows{
      {"  variable", "acts on", "characteristic", "design value", "importance", "partial factor"}};
  for (const DesignValue& v : mode.point)
    rows.push_back({"  " + v.variable, v.acts_on, with_unit(v.characteristic, v.unit), with_unit(v.value, v.unit),
                    percent(v.importance), cell(v.partial_factor)});
  return mode.name + "\n" + columns(rows);
}

std::string codes_table(const ReliabilityAnswer& answer) {
  std::vector<TextRow> rows{{"code: what", "found", "target", ""}};
  std::string none;
  for (const CodeRow& row : answer.codes) {
    const std::optional<bool> holds = row.holds();
    const std::string unit = row.unit.empty() ? "" : " " + row.unit;
    rows.push_back({row.code + ": " + row.what, row.value ? cell(row.value) + unit : "-",
                    row.target ? (row.at_least ? ">= " : "<= ") + cell(row.target) + unit : "-",
                    !holds   ? "-"
                    : *holds ? "holds"
                             : "FAILS"});
    if (!row.why_not.empty() && none.find(row.why_not) == std::string::npos) none += row.why_not + "\n";
  }
  return "\nDemands of codes, side by side (all targets but that of 1998 are assumed, from memory)\n" + columns(rows) +
         none;
}

std::string reasons(const ReliabilityAnswer& answer) {
  std::string text;
  for (const ModeAnswer& mode : answer.modes) {
    if (!mode.why_not.empty()) text += mode.name + ": " + mode.why_not + "\n";
    for (const MethodAnswer& method : mode.methods)
      if (!method.why_not.empty()) text += mode.name + " by " + method.method + ": " + method.why_not + "\n";
    if (!mode.disagreement.empty()) text += mode.name + ": " + mode.disagreement + "\n";
  }
  return text;
}

constexpr double most_variation = 0.3;

NumberedWarnings few_samples(const ReliabilityAnswer& answer) {
  NumberedWarnings list;
  for (const ModeAnswer& mode : answer.modes)
    for (const MethodAnswer& method : mode.methods)
      if (method.variation.value_or(0.) > most_variation)
        list.push_back({"too_few_samples", *method.variation, most_variation, "1",
                        mode.name + ": the probability by " + method.method + " has a coefficient of variation of " +
                            significant(*method.variation, 2),
                        "raise reliability.samples or plain_samples"});
  return list;
}

/// One warning for all modes, with the largest difference.
NumberedWarnings disagreements(const ReliabilityAnswer& answer) {
  double worst = 0.;
  std::string text;
  std::vector<std::string> modes;
  for (const ModeAnswer& mode : answer.modes) {
    if (mode.disagreement.empty()) continue;
    modes.push_back(mode.name);
    if (*mode.spread <= worst) continue;
    worst = *mode.spread;
    text = mode.name + ": " + mode.disagreement;
  }
  if (modes.empty()) return {};
  return {{"methods_disagree", worst, most_spread, "1",
           text + (modes.size() > 1 ? " (likewise other modes of " + join(modes) + ")" : ""),
           "look at which methods agree, take more samples, or let \"plain\" judge where failure is not too rare"}};
}

NumberedWarnings left_out(const ReliabilityAnswer& answer) {
  if (answer.left_out.empty()) return {};
  std::string why;
  for (const std::string& name : answer.left_out) why += "; " + name + ": " + mode_of(answer, name).why_not;
  return {{"system_incomplete", static_cast<double>(answer.left_out.size()), 0., "1",
           "the system leaves out " + join(answer.left_out) + ", and its probability is one at least" + why,
           "give what they need, or [reliability.system.NAME] with the ways to fail that are meant"}};
}

/// Variables act at one level of still water.
NumberedWarnings one_level(const DesignTables& tables) {
  if (tables.levels.empty()) return {};
  std::vector<std::string> names;
  for (const auto& [name, rise] : tables.levels) names.push_back(name);
  return {{"levels_not_used", static_cast<double>(names.size()), 0., "1",
           "probabilities are those at the still water of [section], not at " + join(names) + " of [levels]",
           "let a variable act on the factor water_level, or give [section] at the level that is worst in `upbead "
           "waves`"}};
}

}  // namespace

std::string text_of(const Design& design, const ReliabilityAnswer& answer) {
  const ReliabilityTable& table = *design.tables.reliability;
  std::string text = design.tables.title.empty() ? "" : design.tables.title + "\n";
  text += "wave " + answer.wave + ", " + significant(table.occasions_per_year, 6) + " a year, " +
          significant(table.years, 6) + " years, taken as independent of each other; seed " +
          std::to_string(table.seed) + "\n\nProbability of failure\n";
  std::vector<TextRow> rows{{"mode", "occasion", "year", "life, at most", "beta", "beta of life", "by"}};
  for (const ModeAnswer& mode : answer.modes) rows.push_back(chances_row(mode));
  text += columns(rows) + methods_table(answer) + reasons(answer) + "\nDesign points, where failure is likeliest\n";
  for (const ModeAnswer& mode : answer.modes)
    if (!mode.point.empty()) text += point_table(mode);
  text += codes_table(answer);
  const Checks checks = checks_of(design, answer);
  return text + "\n" + verdict_text(verdict_of(checks, warnings_of(design, answer)), checks);
}

NumberedWarnings warnings_of(const Design& design, const ReliabilityAnswer& answer) {
  NumberedWarnings list = design.implausible;
  append(list, answer.variables);
  append(list, one_level(design.tables));
  append(list, left_out(answer));
  append(list, few_samples(answer));
  append(list, disagreements(answer));
  return list;
}

}  // namespace upbead
