// What comes of the runs of a study: kept in journals while it runs, told in tables and a summary in the end.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "study/study.h"

namespace upbead {

/// What a run took over from the one before it, in the same process.
enum class Shared { nothing, mesh, solution };

struct RunResult {
  bool done = false;                          ///< false: it failed, and `message` says why
  std::vector<std::optional<double>> values;  ///< by Study::reads; none where the summary has none; empty if failed
  std::string message;
  Shared shared = Shared::nothing;
  double seconds = 0.;  ///< wall time
};

/// The results of all runs, by their number; none of those that are still to be run.
using Results = std::vector<std::optional<RunResult>>;

/// Reads all journals of a study of `n_runs`. A last line that was cut off is left out. Throws InputError where they
/// belong to another study: `fingerprint` differs.
Results read_journals(const std::string& output_folder, std::uint64_t fingerprint, std::size_t n_runs);

/// Removes all journals in the folder.
void remove_journals(const std::string& output_folder);

/// The journal of one process. Each line goes to the system at once, so that it outlives the process.
class Journal {
 public:
  /// Makes a file of its own; `rank`: of the process. Throws InputError where the folder cannot be written to.
  Journal(const std::string& output_folder, std::uint64_t fingerprint, int rank);
  /// Throws InputError where the disk is full.
  void add(int run, const RunResult& result);

 private:
  void write(const std::string& line);

  std::string path_;
  std::ofstream stream_;
};

/// The runs that have no result yet, in pieces that stay in one process: runs that differ in [sliding] alone, as one
/// solution does for all of them. The pieces are ordered by case and mesh, so that a process finds its mesh made.
std::vector<std::vector<int>> schedule(const Study& study, const Results& results);

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
