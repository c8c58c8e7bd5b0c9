// The processes that share a study's runs: started by mpirun, or by a cluster's launcher.
#pragma once

#include <memory>

#include "base/stopwatch.h"

namespace upbead {

/// Replaces this process by `mpirun -n processes` with the same command line. Returns only where there is no mpirun.
void launch(int processes);

/// From now on this process prints to the stdout that the launching process has: mpirun passes on what is printed, and
/// does not tell where that cannot be written. Nothing changes where launch() has not started this process, or where
/// that stdout cannot be opened.
void print_past_launcher();

/// Counters that all processes see, in the memory of the first one (an MPI window): a process takes the next piece of
/// work without asking another. To be made and destroyed in all processes at once, while MPI runs.
class Pool {
 public:
  Pool();
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  /// Takes the next piece that no process has taken, and returns its number.
  int take();
  /// Adds runs that have ended.
  void tell(int done, int failed);
  /// Number of runs that have ended, in all processes.
  int done() { return add(finished, 0); }
  int failed() { return add(failures, 0); }
  /// Waits until all processes have called it.
  void meet() const;

 private:
  enum Counter { taken, finished, failures, n_counters };
  struct Window;  // opaque: who includes this header needs no MPI
  /// Adds to a counter; returns its value before.
  int add(Counter counter, int by);

  int rank_ = 0, size_ = 1;
  std::unique_ptr<Window> window_;
};

/// Progress for a person at a terminal. As several processes work, numbers of all of them are passed for each line.
class StudyProgress {
 public:
  /// `n`: number of runs to be done.
  explicit StudyProgress(int n);
  /// Clears the line.
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  /// Whether it is time for another line.
  bool due() const;
  void draw(int done, int failed);

 private:
  int n_;
  bool visible_;
  Stopwatch watch_;
  double drawn_at_ = -1.;  ///< s on the watch; negative before the first line
};

}  // namespace upbead
