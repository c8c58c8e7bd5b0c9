#include <algorithm>

#include "base/text.h"
#include "case/formula_checks.h"
#include "case/formula_wave.h"
#include "design/sheet.h"
#include "output/output_text.h"
#include "reliability/answer.h"
#include "upbead/waves/goda.h"
#include "waves/section_warnings.h"

namespace upbead {

namespace {

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

std::string reasons(const std::vector<CodeRow>& codes) {
  std::string text;
  for (const CodeRow& row : codes)
    if (!row.why_not.empty() && text.find(row.why_not) == std::string::npos) text += row.why_not + "\n";
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

constexpr double most_ground_error = 0.02;  // of F_T: the margin against sliding is wrong by about as much

/// Design points at which F_T of the reduced model may be wrong, or nobody knows by how much.
NumberedWarnings ground_errors(const ReliabilityAnswer& answer) {
  NumberedWarnings list;
  std::vector<std::string> unknown;
  const ModeAnswer* worst = nullptr;
  for (const ModeAnswer& mode : answer.modes) {
    if (mode.by_ground && !mode.ground_error) unknown.push_back(mode.name);
    if (mode.ground_error && (worst == nullptr || *mode.ground_error > *worst->ground_error)) worst = &mode;
  }
  if (worst != nullptr && *worst->ground_error > most_ground_error)
    list.push_back(
        {"reduced_model_error", *worst->ground_error, most_ground_error, "1",
         worst->name + ": at its design point F_T of the model of [dynamics] may be wrong by up to " +
             significant(100. * *worst->ground_error, 2) + " %",
         "make the model with a smaller [accuracy] tolerance, or march that soil and wave with 'upbead run'"});
  if (!unknown.empty())
    list.push_back({"no_error_estimate", 0., most_ground_error, "1",
                    join(unknown) + ": the model of [dynamics] holds nothing from which the error of F_T follows",
                    "make the model again with 'upbead reduce'"});
  return list;
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
  std::vector<std::string> names;
  for (const auto& [name, rise] : tables.levels) names.push_back(name);
  return levels_not_used(
      names.size(), "probabilities are those at the still water of [section], not at " + join(names) + " of [levels]",
      "let a variable act on the factor water_level, or give [section] at the level that is worst in `upbead waves`");
}

/// Of the wave whose numbers are random, as `upbead waves` tells them.
NumberedWarnings wave_warnings(const DesignTables& tables, const std::string& name) {
  const DesignWave wave = design_wave(tables.waves.at(name), tables.section, tables.water);
  const Goda goda(tables.section, tables.water, wave);
  NumberedWarnings list = warnings(tables.section, tables.water, wave, goda.at(wave.height));
  for (NumberedWarning& warning : list) warning.what = "wave " + name + ": " + warning.what;
  return list;
}

}  // namespace

std::string brief(const Design& design, const ReliabilityAnswer& answer, const Json& summary) {
  const std::vector<OutputRow> rows = rows_of_reliability();
  const std::string title = design.tables.title.empty() ? "" : design.tables.title + "\n";
  const Checks checks = checks_of(design, answer);
  return title + text_of(summary, rows, {"wave", "years", "occasions_per_year", "seed"}) +
         "\nProbability of failure\n" +
         table_of(summary["modes"], rows, "modes.NAME",
                  {{"occasion", "occasion.probability"},
                   {"year", "year.probability"},
                   {"life, at most", "life.probability"},
                   {"beta", "occasion.index"},
                   {"beta of life", "life.index"},
                   {"by", "governing"}},
                  "mode") +
         reasons(answer) +
         "\nDemands of codes, side by side (all targets but that of 1998 are assumed, from memory)\n" +
         table_of(summary["codes"], rows, "codes[]",
                  {{"code", "code"},
                   {"what", "what"},
                   {"found", "value"},
                   {"target", "target"},
                   {"at least", "at_least"},
                   {"unit", "unit"},
                   {"holds", "holds"}}) +
         reasons(answer.codes) + "\n" + verdict_text(verdict_of(checks, warnings_of(design, answer)), checks);
}

NumberedWarnings warnings_of(const Design& design, const ReliabilityAnswer& answer) {
  NumberedWarnings list = design.implausible;
  append(list, wave_warnings(design.tables, answer.wave));
  append_new(list, section_warnings(at_means(design.tables).section, at_means(design.tables).water));
  append(list, answer.variables);
  append(list, one_level(design.tables));
  append(list, left_out(answer));
  append(list, few_samples(answer));
  append(list, disagreements(answer));
  append(list, ground_errors(answer));
  append_new(list, answer.lives);
  return list;
}

}  // namespace upbead
