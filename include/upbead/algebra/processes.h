// Several processes that work on one problem together.
#pragma once

#include <memory>
#include <vector>

namespace upbead {

/// What the processes of one run say to each other. All make the same calls in the same order.
class Processes {
 public:
  virtual ~Processes() = default;
  virtual int rank() const = 0;  ///< from 0
  virtual int count() const = 0;
  /// Replaces n values by their sums over all processes, the same to the last bit on each.
  virtual void sum(double* values, int n) const = 0;
  /// Ends all processes at once with this exit code; does not return.
  [[noreturn]] virtual void end_all(int exit_code) const = 0;
};

/// The processes that mpirun, or a cluster's launcher, has started; null where this process is alone. MPI must run
/// (PetscSession).
std::shared_ptr<const Processes> started_processes();

/// The unknowns that several processes share. Each process has a part of the matrix, and the matrix is the sum of the
/// parts. Every process lists all shared unknowns, in the same order.
struct Sharing {
  std::shared_ptr<const Processes> processes;  ///< null: nothing is shared
  std::vector<int> unknowns;                   ///< their indices here, ascending
};

}  // namespace upbead
