#include "confinement.h"

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string_view>

#include "base/confined_work.h"

namespace upbead::detail {

namespace {

/// `refused` and `hidden_ending` of confine(). Global, as a process has one filter and one handler of SIGSYS.
RefusedCalls* noted = nullptr;
char hidden[16] = "";

/// Value of a sixth argument, which newfstatat does not have: the filter lets the handler's own calls pass by it.
constexpr scmp_datum_t own_call = 0x7570626561640001;

/// Calls that show what a file was meant to do, and which argument of the call is a path (-1: none).
struct Telling {
  int number;
  int path;
  const char* what;
};

const Telling telling[] = {
    {SCMP_SYS(open), 0, "write the file"},
    {SCMP_SYS(openat), 1, "write the file"},
    {SCMP_SYS(openat2), 1, "open the file"},
    {SCMP_SYS(creat), 0, "write the file"},
    {SCMP_SYS(truncate), 0, "shorten the file"},
    {SCMP_SYS(mkdir), 0, "make the folder"},
    {SCMP_SYS(mkdirat), 1, "make the folder"},
    {SCMP_SYS(mknod), 0, "make the file"},
    {SCMP_SYS(mknodat), 1, "make the file"},
    {SCMP_SYS(unlink), 0, "remove the file"},
    {SCMP_SYS(unlinkat), 1, "remove the file"},
    {SCMP_SYS(rmdir), 0, "remove the folder"},
    {SCMP_SYS(rename), 0, "rename the file"},
    {SCMP_SYS(renameat), 1, "rename the file"},
    {SCMP_SYS(renameat2), 1, "rename the file"},
    {SCMP_SYS(link), 0, "link the file"},
    {SCMP_SYS(linkat), 1, "link the file"},
    {SCMP_SYS(symlink), 0, "link the file"},
    {SCMP_SYS(symlinkat), 0, "link the file"},
    {SCMP_SYS(chmod), 0, "change the rights of"},
    {SCMP_SYS(fchmodat), 1, "change the rights of"},
    {SCMP_SYS(chown), 0, "change the owner of"},
    {SCMP_SYS(fchownat), 1, "change the owner of"},
    {SCMP_SYS(execve), 0, "start the program"},
    {SCMP_SYS(execveat), 1, "start the program"},
    {SCMP_SYS(fork), -1, "start a program"},
    {SCMP_SYS(vfork), -1, "start a program"},
    {SCMP_SYS(clone), -1, "start a program"},
    {SCMP_SYS(pipe), -1, "start a program"},
    {SCMP_SYS(pipe2), -1, "start a program"},
    {SCMP_SYS(socket), -1, "open a connection"},
    {SCMP_SYS(socketpair), -1, "open a connection"},
    {SCMP_SYS(connect), -1, "open a connection"},
    {SCMP_SYS(kill), -1, "send a signal"},
    {SCMP_SYS(tkill), -1, "send a signal"},
    {SCMP_SYS(tgkill), -1, "send a signal"},
    {SCMP_SYS(rt_sigqueueinfo), -1, "send a signal"},
    {SCMP_SYS(ptrace), -1, "look into another process"},
    {SCMP_SYS(io_uring_setup), -1, "open a way around what it may do"},
    {SCMP_SYS(mount), 1, "mount"},
};

const Telling* telling_of(int number) {
  const auto* const found = std::find_if(std::begin(telling), std::end(telling),
                                         [number](const Telling& call) { return call.number == number; });
  return found == std::end(telling) ? nullptr : found;
}

/// Calls needed to compute, to use memory and to read files (memfd_create makes memory look like a file). libseccomp
/// skips calls that an architecture does not have.
constexpr const char* harmless =
    "read pread64 readv preadv write writev lseek _llseek close fstat fstat64 statx access faccessat faccessat2 "
    "readlink readlinkat getdents64 getcwd fadvise64 readahead statfs fstatfs flock dup dup2 dup3 poll ppoll "
    "mmap mmap2 mprotect munmap mremap madvise brk futex sched_yield sched_getaffinity getcpu membarrier rseq "
    "set_robust_list set_tid_address get_robust_list rt_sigaction rt_sigprocmask rt_sigreturn sigreturn "
    "sigaltstack restart_syscall getpid gettid getppid getuid geteuid getgid getegid uname sysinfo getrusage "
    "getrlimit times time clock_gettime clock_getres gettimeofday getrandom exit exit_group memfd_create"
#ifdef UPBEAD_ASAN
    " pipe pipe2"
#endif
    ;

/// Argument n of the call that raised SIGSYS; known for some machines only.
unsigned long argument(const ucontext_t& context, int n) {
#if defined(__x86_64__)
  constexpr int registers[] = {REG_RDI, REG_RSI, REG_RDX, REG_R10};
  return static_cast<unsigned long>(context.uc_mcontext.gregs[registers[n]]);
#elif defined(__aarch64__)
  return context.uc_mcontext.regs[n];
#else
  (void)context, (void)n;
  return 0;
#endif
}

void answer(ucontext_t& context, long result) {
#if defined(__x86_64__)
  context.uc_mcontext.gregs[REG_RAX] = result;
#elif defined(__aarch64__)
  context.uc_mcontext.regs[0] = static_cast<unsigned long>(result);
#else
  (void)context, (void)result;  // the value in the register is no success of any of these calls
#endif
}

bool is_hidden(const char* path) {
  const std::string_view name(path), ending(hidden);
  return !ending.empty() && name.size() >= ending.size() && name.substr(name.size() - ending.size()) == ending;
}

/// Does the refused newfstatat for the caller, unless the file is hidden.
long look(const ucontext_t& context) {
  const auto* const path = reinterpret_cast<const char*>(argument(context, 1));
  if (path == nullptr || is_hidden(path)) return -ENOENT;
#ifdef SYS_newfstatat
  const int before = errno;
  const long done =
      syscall(SYS_newfstatat, argument(context, 0), path, argument(context, 2), argument(context, 3), own_call, 0L);
  const long result = done < 0 ? -errno : done;
  errno = before;
  return result;
#else
  return -ENOSYS;
#endif
}

void note(const Telling& call, const ucontext_t& context) {
  if (noted->n >= RefusedCalls::most) return;
  RefusedCalls::Call& kept = noted->call[noted->n++];
  kept.number = call.number;
  const auto* const path = call.path < 0 ? nullptr : reinterpret_cast<const char*>(argument(context, call.path));
  if (path != nullptr) std::strncpy(kept.path, path, sizeof kept.path - 1);
}

/// Handler of SIGSYS, which the filter raises for each call that it does not allow.
void stopped(int, siginfo_t* signal, void* context_of_call) {
  auto& context = *static_cast<ucontext_t*>(context_of_call);
#ifdef SYS_newfstatat
  if (signal->si_syscall == SYS_newfstatat) return answer(context, look(context));
#endif
  const Telling* call = telling_of(signal->si_syscall);
  if (call != nullptr) note(*call, context);
  answer(context, call != nullptr ? -EPERM : -ENOSYS);
}

/// Calls that are harmless with some arguments only. An argument without a rule may have any value.
void allow_by_arguments(scmp_filter_ctx filter) {
  const auto allow = [filter](int number, std::initializer_list<scmp_arg_cmp> arguments) {
    seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, number, static_cast<unsigned>(arguments.size()), arguments.begin());
  };
  constexpr scmp_datum_t writes = O_ACCMODE | O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY);
  allow(SCMP_SYS(open), {SCMP_A1(SCMP_CMP_MASKED_EQ, writes, O_RDONLY)});
  allow(SCMP_SYS(openat), {SCMP_A2(SCMP_CMP_MASKED_EQ, writes, O_RDONLY)});
  if (*hidden == '\0') {
    allow(SCMP_SYS(newfstatat), {});
  } else {
    allow(SCMP_SYS(newfstatat), {SCMP_A3(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, AT_EMPTY_PATH)});
    allow(SCMP_SYS(newfstatat), {SCMP_A4(SCMP_CMP_EQ, own_call)});
  }
  allow(SCMP_SYS(clone), {SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD)});
  allow(SCMP_SYS(prlimit64), {SCMP_A0(SCMP_CMP_EQ, 0), SCMP_A2(SCMP_CMP_EQ, 0)});
  allow(SCMP_SYS(tgkill), {SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid()))});  // abort()
  allow(SCMP_SYS(ioctl), {SCMP_A1(SCMP_CMP_EQ, TCGETS)});                                // isatty()
  for (const int command : {F_GETFD, F_SETFD, F_GETFL, F_DUPFD, F_DUPFD_CLOEXEC, F_GETLK, F_SETLK})
    for (const int number : {SCMP_SYS(fcntl), SCMP_SYS(fcntl64)})
      allow(number, {SCMP_A1(SCMP_CMP_EQ, static_cast<scmp_datum_t>(command))});
}

bool filter_calls() {
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_TRAP);
  if (filter == nullptr) return false;
  std::istringstream names(harmless);
  for (std::string name; names >> name;)
    seccomp_rule_add(filter, SCMP_ACT_ALLOW, seccomp_syscall_resolve_name(name.c_str()), 0);
  // glibc calls clone3 with all signals blocked, where a trap would end the process; after ENOSYS it calls clone
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
  allow_by_arguments(filter);
  struct sigaction action = {};
  action.sa_sigaction = stopped;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  sigaction(SIGSYS, &action, nullptr);
  const bool done = seccomp_load(filter) == 0;
  seccomp_release(filter);
  return done;
}

// Debian 12's <linux/landlock.h> ends at version 2 of the interface; the kernel that runs may know more. Numbers and
// layout are those of the kernel's user interface, see man 2 landlock_create_ruleset.
constexpr long version_flag = 1;
constexpr std::uint64_t read_file = 1U << 2U, read_folder = 1U << 3U;

struct Ruleset {
  std::uint64_t files;   ///< rights that are removed
  std::uint64_t net;     ///< since version 4: bind and connect by TCP
  std::uint64_t scoped;  ///< since version 6: abstract sockets and signals of other processes
};

#ifdef SYS_landlock_create_ruleset
std::uint64_t rights_of_files(long version) {
  const int n = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
  return ((std::uint64_t{1} << n) - 1U) & ~(read_file | read_folder);
}
#endif

/// Takes from this process the rights to write, make, rename and remove files, to start programs, to open TCP
/// connections and to signal others, as far as the kernel knows them. False where it has no Landlock. Needs
/// no_new_privs. Source: man 7 landlock.
bool restrict_files() {
#ifdef SYS_landlock_create_ruleset
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, version_flag);
  if (version < 1) return false;
  const Ruleset rules{rights_of_files(version), 3U, 3U};
  const std::size_t size = version >= 6   ? sizeof rules
                           : version >= 4 ? offsetof(Ruleset, scoped)
                                          : offsetof(Ruleset, net);
  const long set = syscall(SYS_landlock_create_ruleset, &rules, size, 0);
  if (set < 0) return false;
  const bool done = syscall(SYS_landlock_restrict_self, set, 0) == 0;
  close(static_cast<int>(set));
  return done;
#else
  return false;
#endif
}

}  // namespace

void confine(RefusedCalls& refused, const std::string& hidden_ending) {
  noted = &refused;
  hidden_ending.copy(hidden, sizeof hidden - 1);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const bool files = restrict_files();
  refused.confined = filter_calls() || files;
}

std::vector<std::string> described(const RefusedCalls& refused) {
  std::vector<std::string> list;
  for (int i = 0; i < std::clamp(refused.n, 0, RefusedCalls::most); ++i) {
    const RefusedCalls::Call& call = refused.call[i];
    const Telling* what = telling_of(call.number);
    if (what == nullptr) continue;
    const std::string path(call.path, strnlen(call.path, sizeof call.path));
    std::string text = what->what + (path.empty() ? "" : " '" + path + "'");
    if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
  }
  return list;
}

}  // namespace upbead::detail

void upbead::forget_refused() {
  if (detail::noted != nullptr) detail::noted->n = 0;
}
