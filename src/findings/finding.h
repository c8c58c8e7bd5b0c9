// A finding: one topic of a summary, in one file. What follows from its declaration: the object in summary.json and its
// row in docs, Python and on the terminal, warnings, checks and with them the verdict, what was skipped.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "findings/evidence.h"
#include "output/checks.h"
#include "output/output_schema.h"
#include "upbead/output/summary.h"

namespace upbead {

using SkippedList = std::vector<Skipped>;

/// Every slot may be empty.
struct Finding {
  OutputSchema<Summary> keys;
  /// Warnings of a scene that are known without solving it; the time of the peak of F_T, where it is known (s).
  std::function<NumberedWarnings(const Simulation&, const std::optional<double>& peak_time)> of_scene;
  /// The same of what is skipped; whether a reduced model solves the scene.
  std::function<SkippedList(const Simulation&, bool reduced)> skipped_of_scene;
  std::function<NumberedWarnings(const Evidence&, const Summary&)> warnings;
  std::function<SkippedList(const Evidence&, const Summary&)> skipped;
  std::function<Checks(const Scene&, const Summary&)> checks;
  /// Whether its checks are of the state before the waves, or by formulas: without a state at rest only these hold.
  bool needs_no_march = false;
  std::vector<std::function<void(const Evidence&, Summary&)>> parts;

  /// A part of the summary, and the function that makes it.
  template <class Value, class Of>
  Finding& part(Value Summary::*member, Value (*find)(const Of&)) {
    parts.emplace_back(
        [member, find](const Evidence& evidence, Summary& summary) { summary.*member = evidence.of(find); });
    return *this;
  }
  /// A part that is one of the solution.
  template <class Value>
  Finding& part(Value Summary::*member, Value Solution::*of_solution) {
    parts.emplace_back([member, of_solution](const Evidence& evidence, Summary& summary) {
      summary.*member = evidence.solution.*of_solution;
    });
    return *this;
  }
};

}  // namespace upbead
