// What a reliability index is checked against, and what is checked before one is sought.
#include "base/text.h"
#include "reliability/answer.h"
#include "reliability/fault_tree.h"
#include "reliability/ground.h"
#include "upbead/input/document.h"

namespace upbead {

namespace {

/// What every index stands on: "distributions given by the file: goda normal, height gumbel".
std::string assumed_of(const Design& design) {
  std::vector<std::string> list;
  for (const auto& [name, variable] : design.tables.reliability->variables)
    list.push_back(name + " " + word_of(variable.kind));
  return "occasions are independent of each other; distributions assumed by the file: " + join(list);
}

/// The index of the life of a mode; a life that fails for certain has none, and misses every target.
Check index_check(const Design& design, const ReliabilityAnswer& answer, const ModeAnswer& mode) {
  const bool whole = mode.name == answer.system;
  Check check =
      check_of(FailureMode::failure_of_life, "reliability index of the life" + (whole ? "" : ", " + mode.name), "",
               mode.life.index, "modes." + mode.name + ".life.index", assumed_of(design));
  if (mode.by_history) check.assumption += "; the course P(t) of the wave is assumed by [impact], and linear ground";
  if (whole && !answer.left_out.empty()) check.assumption += words_of_left_out(answer) + ": at most this index";
  check.by = mode.governing.empty() ? "formulas" : mode.governing;
  check.wave = answer.wave;
  check.probability = mode.life.probability;
  check = at_least_as(check, whole ? design.tables.reliability->target : std::nullopt);
  const bool certain = mode.life.probability && *mode.life.probability >= 1.;
  if (mode.life.index || (certain && check.capacity)) return check;
  return not_checked(check, certain ? "it fails for certain, its probability is 1" : mode.why_not);
}

/// A demand of a code whose target the file itself gives.
Check code_check(const CodeRow& row, const std::string& wave) {
  Check check = check_of(FailureMode::failure_of_life, "reliability, " + row.code + ": " + row.what, row.unit,
                         row.value, "codes", row.source);
  check.by = "formulas";
  check.wave = wave;
  check = row.at_least ? at_least_as(check, row.target) : at_most(check, row.target);
  return row.value || row.why_not.empty() ? check : not_checked(check, row.why_not);
}

}  // namespace

void check_random(const DesignTables& tables, const Document& document, Diagnostics& report) {
  DesignTables whole = tables;
  check_ground(whole, document, report);
  check_reliability(whole, document, report);
  std::vector<std::string> names = limit_state_names();
  if (asks_for_ground(tables)) append(names, ground_state_names());
  if (tables.reliability && report.sound("reliability.system"))
    for (const auto& [at, what, cure] : diagnose(tables.reliability->system, names))
      report.add(document.place(dotted("reliability.system", at.key)), "[reliability.system." + at.key + "]: " + what,
                 cure);
  if (tables.sea || tables.storms) check_expected(tables, document, report);
}

Checks checks_of(const Design& design, const ReliabilityAnswer& answer) {
  Checks list{index_check(design, answer, mode_of(answer, answer.system))};
  for (const ModeAnswer& mode : answer.modes)
    if (mode.name != answer.system) list.push_back(index_check(design, answer, mode));
  for (const CodeRow& row : answer.codes)
    if (row.given) list.push_back(code_check(row, answer.wave));
  return list;
}

}  // namespace upbead
