// The processes that share a study's runs: those that mpirun, or a cluster's launcher, has started.
#pragma once

#include <memory>

#include "base/stopwatch.h"

namespace upbead {

/// Becomes `mpirun -n processes` of this very command line. Returns only where there is no mpirun.
void launch(int processes);

/// Counters that all processes see, in the memory of the first one (an MPI window): who takes the next piece of work
/// asks nobody. Make and destroy it in all processes at once, while MPI runs.
class Pool {
 public:
  Pool();
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  /// Number of the next piece that nobody has taken.
  int take();
  /// Tells that runs are over.
  void tell(int done, int failed);
  /// Runs that are over, of all processes.
  int done() { return add(finished, 0); }
  int failed() { return add(failures, 0); }
  /// Waits until all processes have come here.
  void meet() const;

 private:
  enum Counter { taken, finished, failures, n_counters };
  struct Window;  // that who includes this needs no MPI
  /// Adds to a counter; what it was before.
  int add(Counter counter, int by);

  int rank_ = 0, size_ = 1;
  std::unique_ptr<Window> window_;
};

/// Only for a person at a terminal. Several processes work, so that each line is asked of what all of them have done.
class StudyProgress {
 public:
  /// `n`: runs that are to be done.
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
