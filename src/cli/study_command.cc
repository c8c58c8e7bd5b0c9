#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <thread>

#include "base/cores.h"
#include "base/interrupt.h"
#include "base/launch.h"
#include "base/progress.h"
#include "base/work_lock.h"
#include "cli/study_options.h"
#include "study/local_pool.h"
#include "study/runner.h"
#include "study/shared_files.h"
#include "study/study_progress.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// What of a study this process computes: all of it, or a part.
struct Share {
  std::optional<Part> part;
  std::optional<Launch> launch;  ///< of the processes that have the other parts, where a launcher has started them

  std::string lock() const { return part ? part->lock() : WorkLock::of_all; }
  std::string journal() const { return part ? part->name() + "-" : ""; }
};

/// The results of the runs in the pieces alone.
Results of_pieces(const Pieces& pieces, const Results& results) {
  Results own(results.size());
  for (const std::vector<int>& piece : pieces)
    for (const int run : piece) own[static_cast<std::size_t>(run)] = results[static_cast<std::size_t>(run)];
  return own;
}

int number_of_runs(const Pieces& pieces) {
  int n = 0;
  for (const std::vector<int>& piece : pieces) n += static_cast<int>(piece.size());
  return n;
}

/// Computes runs in processes of this machine, and writes every result to a journal at once. Returns 0, or the exit
/// code of one that could not go on.
int work(const Study& study, const Pieces& pieces, const Share& share, const StudyOptions& options,
         StudyAccount& account) {
  StudyProgress progress(number_of_runs(pieces));
  LocalPool pool(pieces, account.processes, share.journal());
  const auto meanwhile = [&] {
    check_interrupt();
    if (progress.due()) progress.draw(pool.done(), pool.failed());
  };
  const auto give_up = [&](int run, const std::string& why) {
    RunResult failed;
    failed.message = why;
    Journal(options.out, study, pool.next_name()).add(run, failed);
  };
  const auto has_written = [&](int run) {
    const JournalsRead read = read_journals(options.out, study, share.journal());
    const std::optional<RunResult>& result = read.results[static_cast<std::size_t>(run)];
    return result && result->done;
  };
  const int code = pool.work({meanwhile, give_up, has_written});
  account.lost = pool.lost();
  if (account.lost > 0) Journal(options.out, study, pool.next_name()).add_lost(account.lost);
  return code;
}

/// What one of these processes does.
int serve(const StudyWorker& worker, const StudyOptions& options) {
  const Study study = read_study(options.file, options.overrides);
  Journal journal(options.out, study, worker.name);
  Runner runner(study, options.out, !options.no_sharing, options.trusts_scripts);
  worker.serve([&](int run) {
    const RunResult result = runner.run(run, [] {});
    journal.add(run, result);
    return result.done;
  });
  return 0;
}

/// A run without a result was computed, but its line did not come through: a disk that lies.
void fail_lost(const Pieces& pieces, Results& results) {
  for (const std::vector<int>& piece : pieces)
    for (const int run : piece) {
      std::optional<RunResult>& result = results[static_cast<std::size_t>(run)];
      if (result) continue;
      result.emplace();
      result->message = "it was computed, but its line in the journal is not whole: the same command does it again";
    }
}

/// Where a launcher has started the parts, the first process that finds all results joins them. Others end well
/// whatever has failed, as launchers end all processes once one ends otherwise.
int finish_launched(const Study& study, const JournalsRead& read, const Share& share, const StudyOptions& options,
                    StudyAccount account, const Stopwatch& since_start) {
  const std::string id = share.launch->id, once = (journal_folder(options.out) / (id + merged_ending)).string();
  const int done = n_results(read.results), n = static_cast<int>(study.runs.size());
  if (done == n && !id.empty() && is_first(once)) {
    account.resumed.reset();
    account.processes = share.part->of * std::max(1, options.jobs);
    return merge(study, read, options, account, since_start);
  }
  std::cerr << "upbead: part " << share.part->text() << " has ended; " << done << " of " << n
            << " runs of the study have results"
            << (done < n     ? "; once all have, unless it is done then: "
                : id.empty() ? ": "
                             : ", which another part joins, or else: ")
            << command_of(options, " --merge") << "\n";
  return 0;
}

/// Tells what was computed; returns the exit code.
int finish(const Study& study, const Pieces& pieces, const Share& share, const StudyOptions& options,
           StudyAccount& account, const Stopwatch& since_start) {
  JournalsRead read = read_journals(options.out, study);
  if (share.launch) return finish_launched(study, read, share, options, account, since_start);
  fail_lost(pieces, read.results);
  account.seconds = since_start.seconds();
  if (!share.part) return write_tables(study, read.results, options, account);
  const Results own = of_pieces(pieces, read.results);
  account.part = share.part->text();
  std::cout << (options.json ? to_json(study, own, account)
                             : describe(study, own, account) + "next        " + command_of(options, " --merge") +
                                   ", once all parts are done\n")
            << std::flush;
  return n_failed(own) > 0 ? exit_failed_runs : 0;
}

/// The pieces of the share whose runs have no result yet. Tells of lines that are torn where these are now done again.
Pieces left_of(const Study& study, const Pieces& pieces, const Share& share, const StudyOptions& options,
               StudyAccount& account) {
  const JournalsRead read = read_journals(options.out, study, share.journal());
  Pieces left = without_done(pieces, read.results);
  account.resumed = number_of_runs(pieces) - number_of_runs(left);
  if (left.empty() || read.torn == 0) return left;
  account.torn = read.torn;
  std::cerr << "upbead: lines of the journal that are not whole: " << read.torn << "; their runs are done again\n";
  return left;
}

int tell_interrupted(const Interrupted& interrupted, const Study& study, const Pieces& pieces, const Share& share,
                     const StudyOptions& options) {
  if (!share.launch || share.launch->rank == 0)
    std::cerr << "upbead: interrupted; " << n_results(of_pieces(pieces, read_journals(options.out, study).results))
              << " of " << number_of_runs(pieces) << " runs" << (share.part ? " of the part" : "")
              << " are done, the same command goes on with the rest\n";
  return exit_signal + interrupted.signal();
}

int run(const Share& share, const StudyOptions& options, const Stopwatch& since_start) {
  const Study study = read_study_of(options);
  const WorkLock lock(options.out, share.lock());
  if (options.restart) remove_journals(options.out);
  const Pieces pieces = share.part ? deal(study, share.part->of)[static_cast<std::size_t>(share.part->number) - 1]
                                   : schedule(study, Results(study.runs.size()));
  StudyAccount account;
  const Pieces left = left_of(study, pieces, share, options, account);
  const int jobs = options.jobs > 0 ? options.jobs : share.part ? 1 : available_cores();
  account.processes = std::max(1, std::min(jobs, static_cast<int>(left.size())));
  note_interrupts();
  try {
    if (!options.no_sharing && !left.empty())
      make_soil_families(study, left, options.out, options.trusts_scripts, shown_progress("one model for many soils"));
    if (!left.empty())
      if (const int code = work(study, left, share, options, account); code != 0) return code;
  } catch (const Interrupted& interrupted) {
    return tell_interrupted(interrupted, study, pieces, share, options);
  }
  return finish(study, pieces, share, options, account, since_start);
}

/// The share that the command line asks for, or the launcher that has started this process among others.
Share share_of(const StudyOptions& options) {
  if (!options.part.empty() && options.part != "auto") return {read_part(options.part), {}};
  std::optional<Launch> launch = launch_of_environment();
  if (launch && launch->size == 1) launch.reset();
  if (!launch && options.part.empty()) return {};
  const Launch mine = launch ? *launch : launch_of_array();
  const Part part{mine.rank + 1, mine.size};
  if (!launch || mine.rank == 0) std::cerr << "upbead: part " << part.text() << ", by " << mine.by << "\n";
  return {part, launch};
}

void refuse(const std::string& options, const std::string& why, const std::string& cure) {
  throw InputError({options}, why, cure);
}

void check_options(const StudyOptions& options, const Share& share) {
  if (options.merge && !options.part.empty())
    refuse("--merge", "joins all parts, and computes none", "leave out --part, or --merge");
  if (options.follow && !options.merge) refuse("--follow", "follows the parts until it joins them", "add --merge");
  if (options.restart && options.merge) refuse("--restart", "forgets what --merge joins", "leave out one of them");
  if (options.restart && share.part)
    refuse("--restart", "one part cannot know what others have begun to compute anew",
           "remove the folder " + journal_folder(options.out).string() + " before all parts are started");
}

/// Of processes that a launcher has started, the first one tells a mistake: mpirun then ends the others meanwhile.
int run_launched(const Share& share, const StudyOptions& options, const Stopwatch& since_start) {
  try {
    check_options(options, share);
    if (options.merge) return share.launch && share.launch->rank > 0 ? 0 : merge(options, since_start);
    return run(share, options, since_start);
  } catch (const InputError&) {
    if (share.launch && share.launch->rank > 0) std::this_thread::sleep_for(std::chrono::seconds(5));
    throw;
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

A failed run is a row that says why; the exit code then is 2.

On many machines each computes a part, with journals of its own on a shared disk, and none waits for another;
--merge joins them, and tells what is missing and the command that does it:
  sbatch --array=1-100 --wrap 'upbead study STUDY --part $SLURM_ARRAY_TASK_ID/100'
  parallel upbead study STUDY --part {}/8 ::: $(seq 8)
  upbead study STUDY --merge
  mpirun -n 64 upbead study STUDY            # part RANK+1 of 64 each; the last one joins them

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
          {"--jobs", &options->jobs, "processes (default: one per core; of a part, one)", "", false, false,
           std::pair(1, 100000)},
          {"--part", &options->part, "compute part K of N alone; auto: as mpirun, srun or a Slurm array tells", "K/N"},
          {"--merge", &options->merge, "compute nothing: join the results of all parts, and tell what is missing"},
          {"--follow", &options->follow, "with --merge: show how far the parts are, and join them when all is done"},
          {"--restart", &options->restart, "forget the runs that are done"},
          {"--no-sharing", &options->no_sharing, "mesh and solve every run anew; the numbers are the same"},
          trust_option(options->trusts_scripts)};
  command.texts = {{"--keys", "print every key of a study file with range, default and meaning", study_reference},
                   {"--schema", "print them as JSON Schema, by which an editor completes and checks a study file",
                    study_json_schema}};
  command.footer = study_footer;
  command.work = [options, since_start = Stopwatch()] {
    if (options->out.empty()) options->out = "results/" + std::filesystem::path(options->file).stem().string();
    if (const auto worker = StudyWorker::of_environment()) {
      static const PetscSession of_worker;
      return serve(*worker, *options);
    }
    const Share share = share_of(*options);
    leave_launcher();
    static const PetscSession petsc;
    return run_launched(share, *options, since_start);
  };
  return command;
}

}  // namespace upbead
