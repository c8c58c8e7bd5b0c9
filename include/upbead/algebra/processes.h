// Several processes that work on one problem together.
#pragma once

#include <memory>
#include <vector>

namespace upbead {

namespace detail {
class SharedMatrix;
}
struct Sharing;

/// What the processes of one run say to each other. All make the same calls in the same order.
class Processes {
 public:
  virtual ~Processes() = default;
  virtual int rank() const = 0;  ///< from 0
  virtual int count() const = 0;
  /// Replaces n values by their sums over all processes, the same to the last bit on each.
  virtual void sum(double* values, int n) const = 0;
  /// A symmetric matrix in the shared unknowns, which all processes factorise together.
  virtual std::unique_ptr<detail::SharedMatrix> shared_matrix(const Sharing& sharing) const = 0;
  /// Ends all processes at once with this exit code; does not return.
  [[noreturn]] virtual void end_all(int exit_code) const = 0;
};

/// The processes that mpirun, or a cluster's launcher, has started; null where this process is alone. MPI must run
/// (PetscSession).
std::shared_ptr<const Processes> started_processes();

/// The unknowns that several processes share. Each process has a part of the matrix, and the matrix is the sum of the
/// parts. A process lists the shared unknowns that it holds itself.
struct Sharing {
  std::shared_ptr<const Processes> processes;  ///< null: nothing is shared
  std::vector<int> unknowns;                   ///< their indices here, ascending
  std::vector<int> numbers;                    ///< of each of them, among the shared unknowns of all processes
  int n_all = 0;                               ///< shared unknowns of all processes
};

}  // namespace upbead
