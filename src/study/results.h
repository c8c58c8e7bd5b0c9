// The results of a study's runs: kept in journals while it runs, written as tables and a summary at the end.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/journal.h"
#include "base/parts.h"
#include "study/study.h"
#include "study/summary_reader.h"

namespace upbead {

/// What a run took over from the run before it in the same process: each stage with those before it. Numbers are those
/// of journals.
enum class Shared { nothing = 0, mesh = 1, solution = 2, system = 3, basis = 4, soils = 5 };

struct RunResult {
  bool done = false;                          ///< false: it failed, and `message` says why
  std::vector<std::optional<double>> values;  ///< by Study::reads; none where the summary has no value; empty if failed
  std::string message;
  std::string summary;  ///< the whole summary.json of the run; not in journals
  Doubts doubts;        ///< checks that fail, and warnings
  Shared shared = Shared::nothing;
  /// Where one model answers all soils: estimated, of the history of F_T over its peak.
  std::optional<double> error_estimate;
  std::string why_own;  ///< why it was solved by itself though other soils have one model; "" where it was not
  double seconds = 0.;  ///< wall time
};

/// The results of all runs, by their number; none for runs that are still to come.
using Results = std::vector<std::optional<RunResult>>;

/// What the journals of a study hold.
struct JournalsRead {
  Results results;
  int torn = 0;  ///< lines that are not whole, as a full disk, a killed process or a power cut leave them
  int lost = 0;  ///< processes that were ended while they computed a run
};

/// Reads all journals of a study. A line that is not what was written, as its check shows, is counted, and its run has
/// no result. Throws InputError where they belong to another study, as its fingerprint shows. `torn_of`: only lines of
/// journals with this in their names are counted, as others may be about to be written.
JournalsRead read_journals(const std::string& output_folder, const Study& study, const std::string& torn_of = "");

/// Of empty files in the folder of journals, which name launches whose results have been joined.
constexpr const char* merged_ending = ".merged";

/// Removes all journals, families of soils and summaries of runs in the folder.
void remove_journals(const std::string& output_folder);

/// The journal of one process, see JournalFile.
class Journal {
 public:
  /// `name`: that of its file.
  Journal(const std::string& output_folder, const Study& study, const std::string& name);
  /// Also keeps the run's summary, where the study asks for it. Throws InputError where the disk is full.
  void add(int run, const RunResult& result);
  /// So many processes were ended while they computed a run.
  void add_lost(int processes);

 private:
  const Study& study_;
  std::string output_folder_;
  JournalFile file_;
};

/// How a study was run.
struct StudyAccount {
  std::string part;                  ///< "3/100", of which results are told; "" of a whole study
  std::vector<MissingRuns> missing;  ///< of a whole study
  int processes = 1;
  std::optional<int> resumed = 0;  ///< runs that already had a result; none where only other processes know
  int torn = 0;                    ///< lines of the journals that were not whole, so that their runs were done again
  int lost = 0;                    ///< processes that were ended while they computed a run
  double seconds = 0.;             ///< wall time of this call
};

/// study.csv: one row per run, with a header; an empty cell where a run has no number. Runs without a result are
/// missing.
std::string study_csv(const Study& study, const Results& results);

/// The bytes of study.h5: /runs/{run, case, done, message}, one row per run; /varied/KEY, one row per run; and
/// /read/PATH/{run, value} for the runs that have the number. Throws NumericsError where a number is not finite.
std::string study_h5(const Study& study, const Results& results);

/// summary.json of a study.
std::string to_json(const Study& study, const Results& results, const StudyAccount& account);

/// The summary as text.
std::string describe(const Study& study, const Results& results, const StudyAccount& account);

/// Number of runs that have a result.
int n_results(const Results& results);

/// Number of runs that failed.
int n_failed(const Results& results);

}  // namespace upbead
