// The checks of a study: each of them over all runs, and the run in which it is worst.
#pragma once

#include <string>

#include "output/checks.h"
#include "output/output_schema.h"
#include "study/results.h"

namespace upbead {

/// What a journal keeps of the checks of a run: those that were judged, and given limits that could not be.
Json to_json(const Checks& checks);
Checks checks_from(const Json& list);

/// A check in all runs that have it.
struct CheckInRuns {
  Check worst;
  int failing = 0, judged = 0, unjudged = 0;  ///< runs; `unjudged`: it has a limit there and could not be judged
  std::size_t worst_run = 0;
  std::optional<std::size_t> first_run;  ///< in which it fails
};

/// By their names, the most frequent failures first.
std::vector<CheckInRuns> checks_in_runs(const Results& results);
Json to_json(const std::vector<CheckInRuns>& checks);
/// A line of each that fails, or that some run could not judge, for the terminal; `of`: number of runs.
std::string in_words(const std::vector<CheckInRuns>& checks, std::size_t of);
/// "name; name" of those that fail in one run, each once.
std::string failing_names(const Checks& checks);

}  // namespace upbead
