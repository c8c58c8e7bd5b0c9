#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "base/cores.h"
#include "base/files.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "case/script_trust.h"
#include "cli/command.h"
#include "study/local_pool.h"
#include "study/results.h"
#include "study/runner.h"
#include "study/study_lock.h"
#include "study/workers.h"

namespace upbead {

namespace {

constexpr int exit_input = 1, exit_failed_runs = 2, exit_signal = 128;

const std::vector<std::string> study_files{"study.csv",       "study.h5",           "summary.json",
                                           "journal/*.jsonl", "journal/soils-*.h5", "journal/soils-*.txt",
                                           "runs/*.json"};

struct StudyOptions : CommonOptions {
  int jobs = 0;  ///< 0: one per core
  bool restart = false;
  bool no_sharing = false;
  bool trusts_scripts = false;
};

int number_of_results(const Results& results) {
  return static_cast<int>(std::count_if(results.begin(), results.end(), [](const auto& r) { return r.has_value(); }));
}

int number_of_runs(const std::vector<std::vector<int>>& pieces) {
  int n = 0;
  for (const std::vector<int>& piece : pieces) n += static_cast<int>(piece.size());
  return n;
}

/// Takes pieces of work until none is left, and writes every result to the journal at once.
void work(const Study& study, const std::vector<std::vector<int>>& pieces, const StudyOptions& options, Pool& pool) {
  const int n = number_of_runs(pieces);
  StudyProgress progress(n);
  const auto meanwhile = [&] {
    check_interrupt();
    if (pool.rank() == 0 && progress.due()) progress.draw(pool.done(), pool.failed());
  };
  Journal journal(options.out, study, pool.rank());
  Runner runner(study, options.out, !options.no_sharing, options.trusts_scripts);
  for (std::size_t i = static_cast<std::size_t>(pool.take()); i < pieces.size();
       i = static_cast<std::size_t>(pool.take()))
    for (const int run : pieces[i]) {
      meanwhile();
      const RunResult result = runner.run(run, meanwhile);
      journal.add(run, result);
      pool.tell(1, result.done ? 0 : 1);
    }
  while (pool.rank() == 0 && pool.done() < n) {  // other processes still work on their last pieces
    meanwhile();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  pool.meet();
}

/// The same by processes that this one starts. Returns 0, or the exit code of one that could not go on.
int work_in_processes(const Study& study, const std::vector<std::vector<int>>& pieces, const StudyOptions& options,
                      StudyAccount& account) {
  StudyProgress progress(number_of_runs(pieces));
  LocalPool pool(pieces, account.processes);
  const auto meanwhile = [&] {
    check_interrupt();
    if (progress.due()) progress.draw(pool.done(), pool.failed());
  };
  const auto give_up = [&](int run, const std::string& why) {
    RunResult failed;
    failed.message = why;
    Journal(options.out, study, pool.next_rank()).add(run, failed);
  };
  const int code = pool.work(meanwhile, give_up);
  account.lost = pool.lost();
  return code;
}

/// What one of these processes does.
int serve(const StudyWorker& worker, const StudyOptions& options) {
  const Study study = read_study(options.file, options.overrides);
  Journal journal(options.out, study, worker.rank);
  Runner runner(study, options.out, !options.no_sharing, options.trusts_scripts);
  worker.serve([&](int run) {
    const RunResult result = runner.run(run, [] {});
    journal.add(run, result);
    return result.done;
  });
  return 0;
}

/// A run without a result was computed, but its line did not come through: a disk that lies.
void fail_lost(Results& results) {
  for (std::optional<RunResult>& result : results)
    if (!result) {
      result.emplace();
      result->message = "it was computed, but its line in the journal is not whole: the same command does it again";
    }
}

/// Writes the tables from the journals, and prints a summary; returns the exit code.
int finish(const Study& study, const StudyOptions& options, const StudyAccount& account) {
  Results results = read_journals(options.out, study).results;
  fail_lost(results);
  OutputFolder folder(options.out);
  folder.write("study.csv", study_csv(study, results));
  folder.write("study.h5", study_h5(study, results));
  const std::string json = to_json(study, results, account);
  folder.write("summary.json", json);
  folder.commit();
  std::cout << (options.json ? json
                             : describe(study, results, account) + "written     " + folder.name() +
                                   "/{study.csv, study.h5, summary.json}\n")
            << std::flush;
  return n_failed(results) > 0 ? exit_failed_runs : 0;
}

/// Ends this process without MPI_Finalize, which would wait for the other processes, whatever they are doing.
[[noreturn]] void leave(int code) {
  std::cerr << std::flush;
  std::_Exit(code);
}

int tell_interrupted(const Interrupted& interrupted, const Study& study, const StudyOptions& options) {
  std::cerr << "upbead: interrupted; " << number_of_results(read_journals(options.out, study).results) << " of "
            << study.runs.size() << " runs are done, the same command goes on with the rest\n";
  return exit_signal + interrupted.signal();
}

/// The runs that have a result already. Tells of lines that are torn where their runs are now done again.
Results done_before(const Study& study, const StudyOptions& options, StudyAccount& account, bool is_first) {
  JournalsRead read = read_journals(options.out, study);
  account.resumed = number_of_results(read.results);
  if (account.resumed == static_cast<int>(read.results.size()) || read.torn == 0) return read.results;
  account.torn = read.torn;
  if (is_first)
    std::cerr << "upbead: lines of the journal that are not whole: " << read.torn << "; their runs are done again\n";
  return read.results;
}

void make_families(const Study& study, const std::vector<std::vector<int>>& pieces, const StudyOptions& options) {
  if (options.no_sharing || pieces.empty()) return;
  make_soil_families(study, pieces, options.out, options.trusts_scripts, shown_progress("one model for many soils"));
}

/// Runs the study in this process, or in processes of this machine.
int run_alone(const StudyOptions& options, const Stopwatch& since_start) {
  const Study study = read_study(options.file, options.overrides);
  require_inputs_kept(options.out, study_files, study.inputs);
  {
    const OutputFolder free_to_write(options.out);  // throws where it is not free; released before the runs take it
  }
  const StudyLock lock(options.out);
  if (options.restart) remove_journals(options.out);
  StudyAccount account;
  const std::vector<std::vector<int>> pieces = schedule(study, done_before(study, options, account, true));
  const int jobs = options.jobs > 0 ? options.jobs : available_cores();
  account.processes = std::max(1, std::min(jobs, static_cast<int>(pieces.size())));
  note_interrupts();
  try {
    make_families(study, pieces, options);
    if (account.processes > 1) {
      if (const int code = work_in_processes(study, pieces, options, account); code != 0) return code;
    } else if (!pieces.empty()) {
      Pool alone;
      work(study, pieces, options, alone);
    }
  } catch (const Interrupted& interrupted) {
    return tell_interrupted(interrupted, study, options);
  }
  account.seconds = since_start.seconds();
  return finish(study, options, account);
}

/// Reads the study. Only the first process reports mistakes; the other processes return none.
std::optional<Study> read_study_in(const Pool& pool, const StudyOptions& options) {
  try {
    return read_study(options.file, options.overrides);
  } catch (const InputError&) {
    if (pool.rank() == 0) throw;
    return std::nullopt;
  }
}

/// What the first process does before the others read the journals.
std::unique_ptr<StudyLock> begin(const Study& study, const StudyOptions& options, const Pool& pool) {
  if (pool.rank() > 0) return nullptr;
  require_inputs_kept(options.out, study_files, study.inputs);
  auto lock = std::make_unique<StudyLock>(options.out);
  if (options.restart) remove_journals(options.out);
  return lock;
}

/// Runs the study in the processes that a launcher has started.
int run_among(const StudyOptions& options, const Stopwatch& since_start) {
  Pool pool;
  const std::optional<Study> read = read_study_in(pool, options);
  if (!read) return exit_input;
  const Study& study = *read;
  try {
    const std::unique_ptr<StudyLock> lock = begin(study, options, pool);
    pool.meet();
    StudyAccount account;
    const std::vector<std::vector<int>> pieces =
        schedule(study, done_before(study, options, account, pool.rank() == 0));
    pool.meet();  // all processes read before any writes
    note_interrupts();
    if (pool.rank() == 0) make_families(study, pieces, options);
    pool.meet();
    if (!pieces.empty()) work(study, pieces, options, pool);
    account.processes = pool.size();
    account.seconds = since_start.seconds();
    return pool.rank() > 0 ? 0 : finish(study, options, account);
  } catch (const Interrupted& interrupted) {
    // the launcher ends all processes once one ends, so the first process gets time to print its message
    if (pool.rank() > 0) std::this_thread::sleep_for(std::chrono::seconds(2));
    leave(pool.rank() == 0 ? tell_interrupted(interrupted, study, options) : exit_signal + interrupted.signal());
  } catch (const std::exception& error) {
    if (pool.size() == 1) throw;
    std::cerr << error.what() << "\n";
    leave(exit_input);
  }
}

const char* const study_footer =
    R"(Runs every scene of the study; the keys of a study file are in docs/study.md (or --keys).

Writes into results/NAME (or --out DIR):
  study.csv      one row per run: varied values, what was read, status, message
  study.h5       the same
  summary.json   runs that failed with the command to repeat them, what was skipped, times
  journal/       what is known while it runs; the same command goes on where it stopped
  runs/          the whole summary of each run, where the study has summaries = true

A failed run is a row that says why; the exit code then is 2. On a cluster: mpirun -n 64 upbead study STUDY

Examples:
  upbead study cases/study/stiffness.toml
  upbead study cases/study/stiffness.toml --jobs 8 --out /tmp/stiffness
  postprocess/study.py results/stiffness)";

}  // namespace

Command study_command() {
  const auto options = std::make_shared<StudyOptions>();
  Command command = solver_command("study");
  command.options =
      common_options(*options, "study", "the results (default: results/NAME, NAME as the study's)") +
      std::vector<Option>{
          {"--jobs", &options->jobs, "processes (default: one per core)", "", false, false, std::pair(1, 100000)},
          {"--restart", &options->restart, "forget the runs that are done"},
          {"--no-sharing", &options->no_sharing, "mesh and solve every run anew; the numbers are the same"},
          trust_option(options->trusts_scripts)};
  command.texts = {{"--keys", "print every key of a study file with range, default and meaning", study_reference},
                   {"--schema", "print them as JSON Schema, by which an editor completes and checks a study file",
                    study_json_schema}};
  command.footer = study_footer;
  command.work = [options, since_start = Stopwatch()] {
    if (options->out.empty()) options->out = "results/" + std::filesystem::path(options->file).stem().string();
    if (const auto worker = StudyWorker::of_environment()) return serve(*worker, *options);
    return is_launched() ? run_among(*options, since_start) : run_alone(*options, since_start);
  };
  return command;
}

}  // namespace upbead
