#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

#include "base/files.h"
#include "base/interrupt.h"
#include "cli/study_options.h"
#include "study/shared_files.h"
#include "study/study_progress.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

const std::vector<std::string> study_files{"study.csv",       "study.h5",           "summary.json",
                                           "journal/*.jsonl", "journal/soils-*.h5", "journal/soils-*.txt",
                                           "runs/*.json"};

/// The runs without a result, by the parts that are to do them, each with its command.
std::vector<MissingRuns> missing_runs(const Study& study, const Results& results, const StudyOptions& options) {
  if (n_results(results) == static_cast<int>(results.size())) return {};
  if (const auto parts = parts_begun(options.out)) {
    std::vector<MissingRuns> list = missing_parts(
        options.out, deal(study, *parts), [&](int run) { return results[static_cast<std::size_t>(run)].has_value(); });
    for (MissingRuns& missing : list) missing.command = command_of(options, " --part " + missing.part);
    return list;
  }
  MissingRuns all;
  all.command = command_of(options, "");
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!results[i]) all.runs.push_back(static_cast<int>(i));
  return {all};
}

/// Waits until all runs have results, and shows how many have. Journals are read again after a time that is long
/// against what reading them takes.
JournalsRead followed(const Study& study, const StudyOptions& options) {
  constexpr double least_pause = 1., pause_by_reading = 10.;  // s, and a factor
  const int n = static_cast<int>(study.runs.size());
  StudyProgress progress(n);
  for (;;) {
    const Stopwatch watch;
    JournalsRead read = read_journals(options.out, study);
    const int done = n_results(read.results), failed = n_failed(read.results);
    if (done == n) return read;
    for (const double until = watch.seconds() + std::max(least_pause, pause_by_reading * watch.seconds());
         watch.seconds() < until; std::this_thread::sleep_for(std::chrono::milliseconds(100))) {
      check_interrupt();
      if (progress.due()) progress.draw(done, failed);
    }
  }
}

}  // namespace

Study read_study_of(const StudyOptions& options) {
  Study study = read_study(options.file, options.overrides);
  require_inputs_kept(options.out, study_files, study.inputs);
  return study;
}

std::string command_of(const StudyOptions& options, const std::string& more) {
  return command_line("study", options, (options.trusts_scripts ? " --trust" : "") + more);
}

int write_tables(const Study& study, const Results& results, const StudyOptions& options, const StudyAccount& account) {
  const std::string json = to_json(study, results, account), folder = options.out + "/";
  write_together({{folder + "study.csv", study_csv(study, results)},
                  {folder + "study.h5", study_h5(study, results)},
                  {folder + "summary.json", json}});
  std::cout << (options.json ? json
                             : describe(study, results, account) + "written     " + options.out +
                                   "/{study.csv, study.h5, summary.json}\n")
            << std::flush;
  return n_failed(results) > 0 || !account.missing.empty() ? exit_failed_runs : 0;
}

int merge(const Study& study, const JournalsRead& read, const StudyOptions& options, StudyAccount account,
          const Stopwatch& since_start) {
  const int done = n_results(read.results), n = static_cast<int>(read.results.size());
  if (done == 0)
    throw InputError({options.out}, "holds no result of the study yet",
                     "compute them, in parts: " + command_of(options, " --part K/N"));
  account.missing = missing_runs(study, read.results, options);
  account.torn = read.torn;
  account.lost = read.lost;
  account.seconds = since_start.seconds();
  if (done < n)
    std::cerr << "upbead: " << n - done << " of " << n << " runs have no result; the tables name them missing\n";
  return write_tables(study, read.results, options, account);
}

int merge(const StudyOptions& options, const Stopwatch& since_start) {
  const Study study = read_study_of(options);
  note_interrupts();
  try {
    const JournalsRead read = options.follow ? followed(study, options) : read_journals(options.out, study);
    StudyAccount account;
    account.resumed = n_results(read.results);
    return merge(study, read, options, account, since_start);
  } catch (const Interrupted& interrupted) {
    std::cerr << "upbead: interrupted; the parts go on, and the same command follows them\n";
    return exit_signal + interrupted.signal();
  }
}

}  // namespace upbead
