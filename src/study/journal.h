// What is known of a study while it runs: one line per finished run, safe as soon as it is written.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "run_result.h"

namespace upbead {

/// The results of all runs, by their number; none of those that are still to be run.
using Results = std::vector<std::optional<RunResult>>;

/// Where the journals of a study in that output folder lie.
std::string journal_folder(const std::string& output_folder);

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

}  // namespace upbead
