// Runs of a study in processes of this machine, one of which may die at the cost of its run alone.
#pragma once

#include <sys/types.h>

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// A process that computes runs for another one.
struct StudyWorker {
  std::string name;  ///< of its journal; no other process of the study has it
  int socket = 0;    ///< to that other process

  /// None where this process is no worker. Ends this process where the other one has ended.
  static std::optional<StudyWorker> of_environment();
  /// Computes the runs that are asked for, until none is; `compute` returns whether the run is done, and not failed.
  void serve(const std::function<bool(int run)>& compute) const;
};

/// Starts workers: processes with this one's command line, which find StudyWorker::of_environment(). Hands them runs
/// one by one, so that it knows what a process did that was killed: another one does that run again; a run that has
/// ended two processes is told as failed.
class LocalPool {
 public:
  /// `pieces`: runs of a piece stay in one process. `name`: with which those of journals begin.
  LocalPool(const std::vector<std::vector<int>>& pieces, int processes, std::string name);
  /// Ends the workers that are left.
  ~LocalPool();
  LocalPool(const LocalPool&) = delete;
  LocalPool& operator=(const LocalPool&) = delete;

  /// What is done beside the work: `meanwhile` some times a second, `give_up` of a run that is not tried again, and
  /// why; `has_written`: whether a process that was ended had written the whole result of its run.
  struct Beside {
    std::function<void()> meanwhile;
    std::function<void(int run, const std::string& why)> give_up;
    std::function<bool(int run)> has_written;
  };
  /// Works until all is done. Returns 0, or the exit code with which a worker has ended, after a message of its own.
  int work(const Beside& beside);

  int done() const { return done_; }
  int failed() const { return failed_; }
  /// Processes that were ended while they computed a run.
  int lost() const { return lost_; }
  /// The name of a journal that no worker has.
  std::string next_name() { return name_ + std::to_string(n_started_++); }

 private:
  struct Process {
    pid_t id = 0;
    int socket = -1;
    std::deque<int> runs;  ///< its piece; it computes the first one
  };

  void start_process();
  void hand_out(Process& process);
  bool take_answer(Process& process);
  void bury(Process& process, const Beside& beside);

  std::string name_;
  std::deque<std::deque<int>> pieces_;  ///< that no process has
  std::vector<Process> processes_;
  std::map<int, int> deaths_;  ///< by run
  int n_started_ = 0, done_ = 0, failed_ = 0, lost_ = 0, exit_code_ = 0;
};

}  // namespace upbead
