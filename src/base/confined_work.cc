#include "base/confined_work.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>

#include "base/interrupt.h"
#include "base/parcel.h"
#include "confinement.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using detail::RefusedCalls;

enum class Kind { result, input_error, exception, no_memory };

/// Follows the bytes that a confined process returns: tells whether they are complete, and of which kind they are.
struct Trailer {
  std::size_t size;
  Kind kind;
};

constexpr int way_back = 3;  ///< file descriptor of the pipe; a confined process has no other open file but 0 to 2
constexpr int ended_by_exit = 77;

/// Memory that both processes see.
class SharedNotes {
 public:
  SharedNotes()
      : memory_(mmap(nullptr, sizeof(RefusedCalls), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::runtime_error("no memory for a process that reads files");
    new (memory_) RefusedCalls;
  }
  ~SharedNotes() { munmap(memory_, sizeof(RefusedCalls)); }
  SharedNotes(const SharedNotes&) = delete;
  SharedNotes& operator=(const SharedNotes&) = delete;
  RefusedCalls& operator*() const { return *static_cast<RefusedCalls*>(memory_); }

 private:
  void* memory_;
};

void close_other_files(int pipe) {
  if (pipe != way_back) dup2(pipe, way_back);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, standard);
  if (close_range(way_back + 1, ~0U, 0) == 0) return;
  for (long file = sysconf(_SC_OPEN_MAX) - 1; file > way_back; --file) close(static_cast<int>(file));
}

void set_limit(decltype(RLIMIT_CPU) what, rlim_t most) {
  rlimit limit{};
  getrlimit(what, &limit);
  limit.rlim_cur = std::min(most, limit.rlim_max);
  // a hard limit above the soft one, so that SIGXCPU (time) differs from SIGKILL
  limit.rlim_max = std::min(limit.rlim_max, what == RLIMIT_CPU ? most + 2 : most);
  setrlimit(what, &limit);
}

void limit(const ConfinedLimits& limits) {
  set_limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)));
  set_limit(RLIMIT_CORE, 0);
#ifndef UPBEAD_ASAN  // its runtime reserves terabytes of addresses
  rlim_t pages = 0;
  if (std::ifstream("/proc/self/statm") >> pages)
    set_limit(RLIMIT_AS, pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + limits.memory);
#endif
}

void hand_back(Kind kind, std::string bytes) {
  const Trailer trailer{bytes.size(), kind};
  bytes.append(reinterpret_cast<const char*>(&trailer), sizeof trailer);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = write(way_back, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) _exit(1);
    done += static_cast<std::size_t>(n);
  }
}

void hand_back_work(const std::function<std::string()>& work) {
  try {
    hand_back(Kind::result, work());
  } catch (const InputError& error) {
    Parcel parcel;
    parcel.put(error.diagnostics());
    hand_back(Kind::input_error, parcel.take());
  } catch (const std::bad_alloc&) {
    hand_back(Kind::no_memory, "");
  } catch (const std::exception& error) {
    hand_back(Kind::exception, error.what());
  } catch (...) {
    hand_back(Kind::exception, "an unknown exception");
  }
}

[[noreturn]] void be_confined(int pipe, const std::function<std::string()>& work, const ConfinedLimits& limits,
                              RefusedCalls& notes) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM, SIGPIPE})
    std::signal(signal, SIG_DFL);
  close_other_files(pipe);
  limit(limits);
  std::atexit([] { _exit(ended_by_exit); });  // an exit() of the work skips the handlers of the parent process
  detail::confine(notes, limits.hidden_ending);
  hand_back_work(work);
  _exit(0);
}

/// The process that works. The destructor ends it.
class Worker {
 public:
  Worker(const std::function<std::string()>& work, const ConfinedLimits& limits, RefusedCalls& notes) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a process that reads files");
    id_ = fork();
    if (id_ == 0) be_confined(ends[1], work, limits, notes);
    close(ends[1]);
    from_ = ends[0];
    if (id_ < 0) close(from_);
    if (id_ < 0) throw std::runtime_error("no process to read files in: " + std::string(std::strerror(errno)));
    constexpr int large = 1 << 20;
    fcntl(from_, F_SETPIPE_SZ, large);
  }
  ~Worker() {
    close(from_);
    if (id_ <= 0) return;
    kill(id_, SIGKILL);
    wait();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// All bytes that the process returns; "" where it is `stuck`.
  std::string received() {
    constexpr int second = 1000, patience = 60;
    std::string bytes;
    pollfd ready{from_, POLLIN, 0};
    for (int idle = 0; idle < patience;) {
      check_interrupt();
      const double before = computed();
      const int n = poll(&ready, 1, second);
      if (n == 0) idle = computed() > before ? 0 : idle + 1;
      if (n <= 0) continue;
      if (!receive(bytes)) return bytes;
    }
    stuck = true;
    kill(id_, SIGKILL);
    return "";
  }
  int wait() {
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return status;
  }

  bool stuck = false;

 private:
  /// False at the end of the pipe.
  bool receive(std::string& bytes) const {
    constexpr std::size_t piece = 1 << 20;
    const std::size_t old = bytes.size();
    bytes.resize(old + piece);
    const ssize_t n = read(from_, bytes.data() + old, piece);
    bytes.resize(old + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    return n > 0 || (n < 0 && errno == EINTR);
  }
  /// CPU time of the process so far (s).
  double computed() const {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(id_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  pid_t id_ = -1;
  int from_ = -1;
};

/// Removes the trailer; false where the bytes are not complete.
bool is_whole(std::string& bytes, Kind& kind) {
  Trailer trailer{};
  if (bytes.size() < sizeof trailer) return false;
  std::memcpy(&trailer, bytes.data() + bytes.size() - sizeof trailer, sizeof trailer);
  bytes.resize(bytes.size() - sizeof trailer);
  kind = trailer.kind;
  return trailer.size == bytes.size();
}

std::string end_of(int status, bool stuck, const ConfinedLimits& limits) {
  if (stuck) return "waits for something that does not come";
  if (WIFEXITED(status) && WEXITSTATUS(status) == ended_by_exit) return "ends the program";
  if (!WIFSIGNALED(status)) return "ends without an answer";
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL)
    return "takes more than " + std::to_string(std::lround(limits.seconds)) + " s of computing, or was killed";
  if (signal == SIGSYS) return "was stopped";
  return "breaks down (" + std::string(strsignal(signal)) + ")";
}

std::string no_memory(const ConfinedLimits& limits) {
  return "asks for more than " + std::to_string(limits.memory >> 20U) + " MB of memory";
}

}  // namespace

ConfinedOutcome work_confined(const std::function<std::string()>& work, const ConfinedLimits& limits) {
  const SharedNotes notes;
  Worker worker(work, limits, *notes);
  std::string bytes = worker.received();
  const int status = worker.wait();
  check_interrupt();
  ConfinedOutcome outcome;
  outcome.refused = described(*notes);
  outcome.confined = (*notes).confined;
  Kind kind{};
  if (!is_whole(bytes, kind)) {
    outcome.end = end_of(status, worker.stuck, limits);
    // glibc blocks all signals only while system(), fork() and the like start a process
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS) outcome.refused.emplace_back("start a program");
  } else if (kind == Kind::result) {
    outcome.result = std::move(bytes);
  } else if (kind == Kind::input_error) {
    throw InputError(OpenParcel(bytes).diagnostics());
  } else {
    outcome.end = kind == Kind::exception ? "fails: " + bytes : no_memory(limits);
  }
  return outcome;
}

bool can_confine() {
  return work_confined([] { return std::string(); }, ConfinedLimits()).confined;
}

ConfinedLimits limits_for_file(const std::string& file) {
  constexpr double least = 5., per_second = 1e6;  // s, bytes
  constexpr std::size_t base = std::size_t{1} << 30U, growth = 64;
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  ConfinedLimits limits;
  limits.seconds = least + (error ? 0. : static_cast<double>(size) / per_second);
  limits.memory = base + (error ? 0 : growth * size);
  return limits;
}

}  // namespace upbead
