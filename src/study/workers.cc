#include "study/workers.h"

#include <mpi.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "base/progress.h"

namespace upbead {

namespace {

constexpr double redraw_after = 0.2;        // s
constexpr const char* clear = "\r\033[2K";  // back to the first column, erase the line

}  // namespace

struct Pool::Window {
  MPI_Win of_mpi = MPI_WIN_NULL;
};

Pool::Pool() : window_(std::make_unique<Window>()) {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  int* counters = nullptr;
  const MPI_Aint bytes = rank_ == 0 ? n_counters * sizeof(int) : 0;
  MPI_Win_allocate(bytes, sizeof(int), MPI_INFO_NULL, MPI_COMM_WORLD, &counters, &window_->of_mpi);
  MPI_Win_lock_all(0, window_->of_mpi);
  if (rank_ == 0)
    for (int i = 0; i < n_counters; ++i) {
      const int zero = 0;
      MPI_Put(&zero, 1, MPI_INT, 0, i, 1, MPI_INT, window_->of_mpi);
    }
  MPI_Win_flush_all(window_->of_mpi);
  meet();
}

Pool::~Pool() {
  MPI_Win_unlock_all(window_->of_mpi);
  MPI_Win_free(&window_->of_mpi);
}

int Pool::add(Counter counter, int by) {
  int before = 0;
  MPI_Fetch_and_op(&by, &before, MPI_INT, 0, counter, MPI_SUM, window_->of_mpi);
  MPI_Win_flush(0, window_->of_mpi);
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

StudyProgress::StudyProgress(int n) : n_(n), visible_(isatty(STDERR_FILENO) == 1) {}

StudyProgress::~StudyProgress() {
  if (drawn_at_ >= 0.) std::fputs(clear, stderr);
}

bool StudyProgress::due() const {
  return visible_ && (drawn_at_ < 0. || watch_.seconds() - drawn_at_ > redraw_after);
}

void StudyProgress::draw(int done, int failed) {
  std::string what = std::to_string(done) + " of " + std::to_string(n_) + " runs";
  if (failed > 0) what += ", " + std::to_string(failed) + " failed";
  drawn_at_ = watch_.seconds();
  std::fputs((clear + progress_line(what, static_cast<double>(done) / n_, drawn_at_)).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace upbead
