// The tables and the summary of a study.
#pragma once

#include <string>

#include "journal.h"
#include "study/study.h"

namespace upbead {

/// How a study was run.
struct StudyAccount {
  int processes = 1;
  int resumed = 0;      ///< runs that were there already
  double seconds = 0.;  ///< wall time of this call
};

/// study.csv: one row per run, with a header; an empty cell where a run has no number.
std::string study_csv(const Study& study, const Results& results);

/// The bytes of study.h5: /runs/{run, case, done, message}, one row per run; /varied/KEY, one row per run; and of the
/// runs that have the number /read/PATH/{run, value}. Throws NumericsError where a number is not finite.
std::string study_h5(const Study& study, const Results& results);

/// summary.json of a study.
std::string to_json(const Study& study, const Results& results, const StudyAccount& account);

/// What came out, for people.
std::string describe(const Study& study, const Results& results, const StudyAccount& account);

/// Runs that failed.
int n_failed(const Results& results);

}  // namespace upbead
