#include "study/local_pool.h"

#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>

#include "base/cores.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int socket_of_worker = 3;
constexpr int most_deaths = 2;  // of processes by one run
constexpr int milliseconds_between = 100;

/// The words of this process's command line.
std::vector<std::string> command_line() {
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(stream, word, '\0');) words.push_back(word);
  return words;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

/// This process's environment, with one thread each, and "PARENT NAME".
std::vector<std::string> environment_of_worker(const std::string& name) {
  std::vector<std::string> list{std::string(study_worker) + "=" + std::to_string(getpid()) + " " + name,
                                "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const auto same_name = [&text](const std::string& other) {
      return text.compare(0, text.find('=') + 1, other, 0, other.find('=') + 1) == 0;
    };
    if (std::none_of(list.begin(), list.begin() + 3, same_name)) list.push_back(text);
  }
  return list;
}

[[noreturn]] void cannot_start(int error) {
  throw InputError({}, "no further process could be started: " + std::generic_category().message(error),
                   "ask for fewer with --jobs");
}

/// Starts this program again with the same command line; what it prints goes to stderr, so that stdout stays clean.
pid_t spawn(const std::string& name, int socket) {
  std::vector<std::string> words = command_line(), variables = environment_of_worker(name);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, socket_of_worker);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  pid_t id = 0;
  const int error =
      posix_spawn(&id, program.c_str(), &actions, nullptr, pointers(words).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) cannot_start(error);
  return id;
}

}  // namespace

std::optional<StudyWorker> StudyWorker::of_environment() {
  const char* text = std::getenv(study_worker);
  if (text == nullptr) return std::nullopt;
  char* end = nullptr;
  const long parent = std::strtol(text, &end, 10);
  signal(SIGINT, SIG_IGN);  // Ctrl-C reaches all processes of a terminal; the one that has started this one ends it
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) std::_Exit(0);
  return StudyWorker{end + 1, socket_of_worker};
}

void StudyWorker::serve(const std::function<bool(int run)>& compute) const {
  for (int run = 0; recv(socket, &run, sizeof run, 0) == sizeof run;) {
    const int is_done = compute(run) ? 1 : 0;
    if (send(socket, &is_done, sizeof is_done, MSG_NOSIGNAL) < 0) return;
  }
}

LocalPool::LocalPool(const std::vector<std::vector<int>>& pieces, int processes, std::string name)
    : name_(std::move(name)) {
  for (const std::vector<int>& piece : pieces) pieces_.emplace_back(piece.begin(), piece.end());
  for (int i = 0; i < processes; ++i) start_process();
}

LocalPool::~LocalPool() {
  for (const Process& process : processes_) {
    close(process.socket);
    if (!process.runs.empty()) kill(process.id, SIGKILL);
    waitpid(process.id, nullptr, 0);
  }
}

void LocalPool::start_process() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) cannot_start(errno);
  Process process;
  process.socket = ends[0];
  process.id = spawn(next_name(), ends[1]);
  close(ends[1]);
  hand_out(process);
  processes_.push_back(process);
}

/// The next run of its piece, else of a new piece; without any the process ends.
void LocalPool::hand_out(Process& process) {
  if (process.runs.empty() && !pieces_.empty()) {
    process.runs = std::move(pieces_.front());
    pieces_.pop_front();
  }
  if (process.runs.empty())
    shutdown(process.socket, SHUT_WR);
  else
    send(process.socket, &process.runs.front(), sizeof(int), MSG_NOSIGNAL);  // where it has died, that shows later
}

/// False where the process has ended.
bool LocalPool::take_answer(Process& process) {
  int is_done = 0;
  if (recv(process.socket, &is_done, sizeof is_done, MSG_DONTWAIT) != sizeof is_done) return false;
  ++done_;
  if (is_done == 0) ++failed_;
  process.runs.pop_front();
  hand_out(process);
  return true;
}

/// Takes leave of a process that has ended: with its work, or in the middle of it.
void LocalPool::bury(Process& process, const Beside& beside) {
  int status = 0;
  waitpid(process.id, &status, 0);
  close(process.socket);
  const std::deque<int> left = process.runs;
  processes_.erase(processes_.begin() + (&process - processes_.data()));
  if (left.empty()) return;
  if (WIFEXITED(status)) {
    exit_code_ = std::max(1, WEXITSTATUS(status));
    return;
  }
  ++lost_;
  const int run = left.front();
  const std::string how = "by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
  std::deque<int> again = left;
  if (beside.has_written(run)) {
    std::cerr << "upbead: the process of run " << run << " was ended " << how << " once it had written that run\n";
    ++done_;
    again.pop_front();
  } else if (++deaths_[run] < most_deaths) {
    std::cerr << "upbead: the process of run " << run << " was ended " << how << "; another one does that run again\n";
  } else {
    beside.give_up(run, "its process was ended twice, " + how + ", as where memory runs out: run it alone");
    ++done_;
    ++failed_;
    again.pop_front();
  }
  if (!again.empty()) pieces_.push_front(again);
  if (!pieces_.empty()) start_process();
}

int LocalPool::work(const Beside& beside) {
  while (!processes_.empty() && exit_code_ == 0) {
    std::vector<pollfd> sockets;
    for (const Process& process : processes_) sockets.push_back({process.socket, POLLIN, 0});
    poll(sockets.data(), sockets.size(), milliseconds_between);
    for (std::size_t i = sockets.size(); i-- > 0;)  // backwards, as those that have ended are erased
      if (sockets[i].revents != 0 && !take_answer(processes_[i])) bury(processes_[i], beside);
    beside.meanwhile();
  }
  return exit_code_;
}

}  // namespace upbead
