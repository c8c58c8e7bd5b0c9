#include "study/workers.h"

#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/progress.h"

namespace upbead {

namespace {

constexpr const char* terminal = "UPBEAD_TERMINAL";
constexpr const char* launchers_stdout = "UPBEAD_STDOUT";

/// Whether a person sees stderr, directly or through mpirun.
bool has_terminal() {
  return isatty(STDERR_FILENO) == 1 || std::getenv(terminal) != nullptr;
}

/// Texts that each end with a null character, as in files of /proc.
std::vector<std::string> texts_in(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::string> list;
  for (std::string text; std::getline(stream, text, '\0');) list.push_back(text);
  return list;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

/// The environment with which this process was started: PetscSession has since then set Open MPI to a single process.
std::vector<std::string> environment() {
  std::vector<std::string> list = texts_in("/proc/self/environ");
  for (const char* more : {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "OMP_NUM_THREADS=1",
                           "OPENBLAS_NUM_THREADS=1"}) {
    const std::string name = std::string(more).substr(0, std::string(more).find('=') + 1);
    list.erase(std::remove_if(list.begin(), list.end(), [&](const auto& text) { return text.rfind(name, 0) == 0; }),
               list.end());
    list.emplace_back(more);
  }
  if (has_terminal()) list.push_back(std::string(terminal) + "=1");
  // of this process, which mpirun replaces; the first of two with one name counts
  list.insert(list.begin(), std::string(launchers_stdout) + "=/proc/" + std::to_string(getpid()) + "/fd/1");
  return list;
}

constexpr double redraw_after = 0.2;        // s
constexpr const char* clear = "\r\033[2K";  // back to the first column, erase the line

}  // namespace

void launch(int processes) {
  // quiet: the program reports mistakes itself; a container may forbid to bind and to copy between processes
  std::vector<std::string> command{"mpirun",
                                   "--quiet",
                                   "-n",
                                   std::to_string(processes),
                                   "--oversubscribe",
                                   "--bind-to",
                                   "none",
                                   "--mca",
                                   "btl_vader_single_copy_mechanism",
                                   "none",
                                   std::filesystem::read_symlink("/proc/self/exe").string()};
  const std::vector<std::string> own = texts_in("/proc/self/cmdline");
  command.insert(command.end(), own.begin() + 1, own.end());
  std::vector<std::string> variables = environment();
  execvpe("mpirun", pointers(command).data(), pointers(variables).data());
}

void print_past_launcher() {
  const char* const path = std::getenv(launchers_stdout);
  if (path == nullptr) return;
  const int output = open(path, O_WRONLY | O_APPEND | O_NONBLOCK | O_CLOEXEC);  // never waits for a reader
  if (output < 0) return;
  if (fcntl(output, F_SETFL, O_APPEND) == 0) dup2(output, STDOUT_FILENO);
  close(output);
}

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

StudyProgress::StudyProgress(int n) : n_(n), visible_(has_terminal()) {}

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
