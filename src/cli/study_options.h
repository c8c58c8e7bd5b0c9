// What the two halves of `upbead study` share: computing runs, and joining their results.
#pragma once

#include <string>

#include "base/stopwatch.h"
#include "cli/command.h"
#include "study/parts.h"

namespace upbead {

constexpr int exit_failed_runs = 2;

struct StudyOptions : CommonOptions {
  int jobs = 0;      ///< 0: one per core; of a part, one
  std::string part;  ///< --part: K/N or auto
  bool merge = false;
  bool follow = false;
  bool restart = false;
  bool no_sharing = false;
  bool trusts_scripts = false;
};

/// Reads the study. Throws InputError where its results would replace its inputs.
Study read_study_of(const StudyOptions& options);

/// This study's command line, with more behind it.
std::string command_of(const StudyOptions& options, const std::string& more);

/// Writes the tables from the results, and prints a summary; returns the exit code.
int write_tables(const Study& study, const Results& results, const StudyOptions& options, const StudyAccount& account);

/// Joins what the journals of all parts hold; with --follow once all runs have results.
int merge(const StudyOptions& options, const Stopwatch& since_start);

/// The same with the study and its results read. `account`: how they were computed.
int merge(const Study& study, const JournalsRead& read, const StudyOptions& options, StudyAccount account,
          const Stopwatch& since_start);

}  // namespace upbead
