#include "upbead/base/trial_run.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>

namespace upbead {

namespace {

/// Time of computing that is enough to read a file (s).
rlim_t longest_for(const std::string& file) {
  constexpr rlim_t least = 5, megabyte = 1000000;  // s, bytes
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  return least + (error ? 0 : size / megabyte);
}

/// The end by a signal is an answer: nobody else is to handle it, and nothing of it is to be read.
void be_ready_to_die(rlim_t longest) {
  const rlimit limit{longest, longest};
  setrlimit(RLIMIT_CPU, &limit);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

}  // namespace

bool survives(const std::string& file, const std::function<void()>& work) {
  // before the fork: the copy finds the memory as the work in earnest will, so that even what reads memory that was
  // never set ends alike
  const rlim_t longest = longest_for(file);
  const pid_t copy = fork();
  if (copy < 0) return true;
  if (copy == 0) {
    be_ready_to_die(longest);
    try {
      work();
    } catch (...) {  // whatever it is, it comes again where it can be told
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace upbead
