// The processes that share a study's runs: those that mpirun has started.
#pragma once

#include <mpi.h>

namespace upbead {

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
  /// Adds to a counter; what it was before.
  int add(Counter counter, int by);

  int rank_ = 0, size_ = 1;
  MPI_Win window_ = MPI_WIN_NULL;
};

}  // namespace upbead
