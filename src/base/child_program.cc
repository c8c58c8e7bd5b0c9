#include "base/child_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <system_error>

#include "base/interrupt.h"
#include "base/progress.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

[[noreturn]] void cannot_run(const std::string& program, int error) {
  throw InputError({}, "cannot start '" + program + "': " + std::generic_category().message(error),
                   "install upbead again, whole");
}

/// A child whose stderr is read through a pipe; it is ended with this object.
class Child {
 public:
  Child(const std::string& program, std::vector<std::string> words);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// What it has written since, after at most `milliseconds`; false: nothing more will come.
  bool read(int milliseconds, std::string& text) const;
  /// Waits for its end.
  int code();

 private:
  void end();

  pid_t id_ = 0;
  int pipe_ = -1;
};

Child::Child(const std::string& program, std::vector<std::string> words) {
  words.insert(words.begin(), program);
  std::vector<char*> arguments, variables;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::string shows = std::string(progress_through_pipe) + "=1";
  for (char** entry = environ; *entry != nullptr; ++entry) variables.push_back(*entry);
  variables.push_back(shows.data());
  variables.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) cannot_run(program, errno);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  const int error = posix_spawn(&id_, program.c_str(), &actions, nullptr, arguments.data(), variables.data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  pipe_ = ends[0];
  if (error == 0) return;
  close(pipe_);
  cannot_run(program, error);
}

Child::~Child() {
  end();
  close(pipe_);
}

bool Child::read(int milliseconds, std::string& text) const {
  pollfd from{pipe_, POLLIN, 0};
  if (poll(&from, 1, milliseconds) <= 0) return true;
  std::array<char, 4096> bytes;
  const ssize_t n = ::read(pipe_, bytes.data(), bytes.size());
  if (n > 0) text.append(bytes.data(), static_cast<std::size_t>(n));
  return n > 0 || (n < 0 && errno == EINTR);
}

int Child::code() {
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) continue;
  id_ = 0;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// First so that it can remove its files, and after some seconds at once.
void Child::end() {
  if (id_ == 0) return;
  constexpr int tries = 50;
  constexpr useconds_t between = 100'000;  // microseconds
  kill(id_, SIGTERM);
  for (int i = 0; i < tries; ++i) {
    if (waitpid(id_, nullptr, WNOHANG) != 0) return;
    usleep(between);
  }
  kill(id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

}  // namespace

std::string without_progress(const std::string& text, double& share) {
  static const std::regex line("\r\033\\[2K(?:[^\r\n\033]*?: (\\d+) %(?:, \\d+ (?:s|min|h) left)?)?");
  for (std::sregex_iterator found(text.begin(), text.end(), line), end; found != end; ++found)
    if ((*found)[1].matched) share = std::stod((*found)[1]) / 100.;
  return std::regex_replace(text, line, "");
}

ChildEnd run_child(const std::string& name, const std::vector<std::string>& words, const std::string& what) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  Child child((self.parent_path() / name).string(), words);
  Progress shown(what);
  constexpr int wait = 100;  // milliseconds
  double share = 0.;
  std::string text;
  while (child.read(wait, text)) {
    check_interrupt();
    without_progress(text, share);
    shown.update(share);
  }
  ChildEnd end;
  end.code = child.code();
  end.told = without_progress(text, share);
  check_interrupt();
  return end;
}

}  // namespace upbead
