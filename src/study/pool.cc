#include "pool.h"

namespace upbead {

Pool::Pool() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  int* counters = nullptr;
  const MPI_Aint bytes = rank_ == 0 ? n_counters * sizeof(int) : 0;
  MPI_Win_allocate(bytes, sizeof(int), MPI_INFO_NULL, MPI_COMM_WORLD, &counters, &window_);
  MPI_Win_lock_all(0, window_);
  if (rank_ == 0)
    for (int i = 0; i < n_counters; ++i) {
      const int zero = 0;
      MPI_Put(&zero, 1, MPI_INT, 0, i, 1, MPI_INT, window_);
    }
  MPI_Win_flush_all(window_);
  meet();
}

Pool::~Pool() {
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

int Pool::add(Counter counter, int by) {
  int before = 0;
  MPI_Fetch_and_op(&by, &before, MPI_INT, 0, counter, MPI_SUM, window_);
  MPI_Win_flush(0, window_);
  return before;
}

int Pool::take() {
  return add(taken, 1);
}

void Pool::tell(int done, int failed) {
  add(finished, done);
  add(failures, failed);
}

void Pool::meet() const {
  MPI_Barrier(MPI_COMM_WORLD);
}

}  // namespace upbead
