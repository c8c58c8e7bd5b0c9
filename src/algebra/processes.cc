#include "upbead/algebra/processes.h"

#include <mpi.h>

#include <cstdlib>

#include "algebra/mumps_matrix.h"

namespace upbead {

namespace {

class MpiProcesses : public Processes {
 public:
  MpiProcesses() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
  }
  int rank() const override { return rank_; }
  int count() const override { return count_; }

  /// Not by MPI_Allreduce, which may sum in a different order on each process.
  void sum(double* values, int n) const override {
    MPI_Reduce(rank_ == 0 ? MPI_IN_PLACE : values, values, n, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    MPI_Bcast(values, n, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  }

  std::unique_ptr<detail::SharedMatrix> shared_matrix(const Sharing& sharing) const override {
    return std::make_unique<detail::MumpsMatrix>(sharing);
  }

  [[noreturn]] void end_all(int exit_code) const override {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();
  }

 private:
  int rank_ = 0, count_ = 1;
};

}  // namespace

std::shared_ptr<const Processes> started_processes() {
  auto processes = std::make_shared<const MpiProcesses>();
  return processes->count() > 1 ? processes : nullptr;
}

}  // namespace upbead
