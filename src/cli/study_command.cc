#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "base/cores.h"
#include "base/files.h"
#include "base/interrupt.h"
#include "case/script_trust.h"
#include "cli/command.h"
#include "study/results.h"
#include "study/runner.h"
#include "study/workers.h"

namespace upbead {

namespace {

constexpr int exit_input = 1, exit_failed_runs = 2, exit_signal = 128;

const std::vector<std::string> study_files{"study.csv", "study.h5", "summary.json", "journal/*.jsonl"};

struct StudyOptions : CommonOptions {
  int jobs = 0;  ///< 0: one per core
  bool restart = false;
  bool no_sharing = false;
  bool trusts_scripts = false;
};

int number_of_results(const Results& results) {
  return static_cast<int>(std::count_if(results.begin(), results.end(), [](const auto& r) { return r.has_value(); }));
}

/// Takes pieces of work until none is left, and writes every result to the journal at once.
void work(const Study& study, const std::vector<std::vector<int>>& pieces, const StudyOptions& options, Pool& pool) {
  int n = 0;
  for (const std::vector<int>& piece : pieces) n += static_cast<int>(piece.size());
  StudyProgress progress(n);
  const auto meanwhile = [&] {
    check_interrupt();
    if (pool.rank() == 0 && progress.due()) progress.draw(pool.done(), pool.failed());
  };
  Journal journal(options.out, study.fingerprint, pool.rank());
  Runner runner(study, !options.no_sharing, options.trusts_scripts);
  for (std::size_t i = static_cast<std::size_t>(pool.take()); i < pieces.size();
       i = static_cast<std::size_t>(pool.take()))
    for (const int run : pieces[i]) {
      meanwhile();
      const RunResult result = runner.run(study.runs[static_cast<std::size_t>(run)], meanwhile);
      journal.add(run, result);
      pool.tell(1, result.done ? 0 : 1);
    }
  while (pool.rank() == 0 && pool.done() < n) {  // other processes still work on their last pieces
    meanwhile();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  pool.meet();
}

/// Writes the tables from the journals, and prints a summary; returns the exit code.
int finish(const Study& study, const StudyOptions& options, const StudyAccount& account) {
  const Results results = read_journals(options.out, study.fingerprint, study.runs.size());
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

[[noreturn]] void end_interrupted(const Interrupted& interrupted, const Study& study, const StudyOptions& options,
                                  const Pool& pool) {
  // the launcher ends all processes once one ends, so the first process gets time to print its message
  if (pool.rank() > 0) std::this_thread::sleep_for(std::chrono::seconds(2));
  const int n = number_of_results(read_journals(options.out, study.fingerprint, study.runs.size()));
  if (pool.rank() == 0)
    std::cerr << "upbead: interrupted; " << n << " of " << study.runs.size()
              << " runs are done, the same command goes on with the rest\n";
  leave(exit_signal + interrupted.signal());
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

int run_study(const StudyOptions& options, const Stopwatch& since_start) {
  Pool pool;
  const std::optional<Study> read = read_study_in(pool, options);
  if (!read) return exit_input;
  const Study& study = *read;
  require_inputs_kept(options.out, study_files, study.inputs);
  if (pool.rank() == 0 && options.restart) remove_journals(options.out);
  pool.meet();
  const Results before = read_journals(options.out, study.fingerprint, study.runs.size());
  const std::vector<std::vector<int>> pieces = schedule(study, before);
  pool.meet();  // all processes read before any writes
  note_interrupts();
  try {
    if (!pieces.empty()) work(study, pieces, options, pool);
  } catch (const Interrupted& interrupted) {
    end_interrupted(interrupted, study, options, pool);
  } catch (const std::exception& error) {
    if (pool.size() == 1) throw;
    std::cerr << error.what() << "\n";
    leave(exit_input);
  }
  if (pool.rank() > 0) return 0;
  print_past_launcher();
  return finish(study, options, {pool.size(), number_of_results(before), since_start.seconds()});
}

/// Checks everything first, so that mistakes are reported once, then starts as many processes as there is work for.
void start(const StudyOptions& options) {
  const Study study = read_study(options.file, options.overrides);
  require_inputs_kept(options.out, study_files, study.inputs);
  const Results before =
      options.restart ? Results(study.runs.size()) : read_journals(options.out, study.fingerprint, study.runs.size());
  {
    const OutputFolder free_to_write(options.out);  // throws where it is not free; released before the runs take it
  }
  const int jobs = options.jobs > 0 ? options.jobs : available_cores();
  const int processes = std::min(jobs, static_cast<int>(schedule(study, before).size()));
  if (processes < 2) return;
  launch(processes);
  std::cerr << "there is no mpirun: the runs go one after the other\n";
}

const char* const study_footer =
    R"(Runs every scene of the study; the keys of a study file are in docs/study.md (or --keys).

Writes into results/NAME (or --out DIR):
  study.csv      one row per run: varied values, what was read, status, message
  study.h5       the same
  summary.json   runs that failed with the command to repeat them, what was skipped, times
  journal/       what is known while it runs; the same command goes on where it stopped

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
    if (!is_launched()) start(*options);
    return run_study(*options, since_start);
  };
  return command;
}

}  // namespace upbead
