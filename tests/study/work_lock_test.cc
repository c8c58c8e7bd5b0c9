// Claim: a folder has one study at a time, or parts of one division, each once; also on a file system without hard
// links, and none waits for a lock of the file system. What a process has left that was killed keeps nobody out of it.
#include "base/work_lock.h"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "upbead/base/error.h"

namespace {
bool has_links = true;
}

/// Stands for the one of the C library: of a file system with hard links, or of one without.
extern "C" int link(const char* from, const char* to) noexcept {
  if (has_links) return static_cast<int>(syscall(SYS_link, from, to));
  errno = EPERM;
  return -1;
}

/// A lock of a file system may hang; HDF5's files, which are read under one, are no folders.
extern "C" int flock(int descriptor, int operation) noexcept {
  if ((operation & LOCK_EX) != 0) std::abort();
  return static_cast<int>(syscall(SYS_flock, descriptor, operation));
}

namespace upbead::test {
namespace work_lock_test {

namespace fs = std::filesystem;

class WorkLockTest : public testing::TestWithParam<bool> {
 protected:
  WorkLockTest() : folder_(fs::temp_directory_path() / ("upbead-lock-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    has_links = GetParam();
  }
  ~WorkLockTest() override {
    has_links = true;
    fs::remove_all(folder_);
  }

  std::string folder() const { return folder_.string(); }
  fs::path file() const { return folder_ / "journal" / "lock"; }
  std::string text() const {
    std::ifstream stream(file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void leave(const std::string& text) const {
    fs::create_directories(file().parent_path());
    std::ofstream(file()) << text;
  }
  std::string refusal(const std::string& of = WorkLock::of_all) const {
    try {
      const WorkLock lock(folder(), of);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  }
  /// What a process writes into its lock.
  std::string own() const {
    const WorkLock lock(folder());
    return text();
  }
  /// The same of a process of that number that cannot be: the largest is 4194304.
  std::string ended() const {
    const std::string text = own();
    return "4194305 1 " + text.substr(text.find(' ', text.find(' ') + 1) + 1);
  }

  fs::path folder_;
};

TEST_P(WorkLockTest, KeepsASecondOneOutWithPlaceAndCure) {
  {
    const WorkLock lock(folder());
    const std::string refused = refusal();
    EXPECT_NE(refused.find(folder()), std::string::npos);
    EXPECT_NE(refused.find("process " + std::to_string(getpid())), std::string::npos) << refused;
    EXPECT_NE(refused.find("--out DIR"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(file()));
  EXPECT_EQ(refusal(), "");
}

TEST_P(WorkLockTest, OfAProcessThatWasKilledKeepsNobodyOut) {
  const pid_t child = fork();
  if (child == 0) {
    const WorkLock lock(folder());
    _exit(0);  // without its destructor
  }
  siginfo_t how;
  waitid(P_PID, static_cast<id_t>(child), &how, WEXITED | WNOWAIT);  // it stays as a zombie
  EXPECT_NE(text(), "");
  EXPECT_EQ(refusal(), "");
  waitpid(child, nullptr, 0);
  leave(ended());
  EXPECT_EQ(refusal(), "");
  EXPECT_FALSE(fs::exists(file()));
}

TEST_P(WorkLockTest, OfAProcessThatMayRunIsToldWithTheFileToRemove) {
  const std::string text = own(), host = text.substr(text.rfind(' ') + 1);
  const std::size_t system = text.find(' ', text.find(' ') + 1) + 1;
  for (const std::string& left : {std::string("1 2 another-bootpid:[1] elsewhere\n"), std::string(), std::string("12"),
                                  std::string("no owner at all\n")}) {
    leave(left);
    EXPECT_NE(refusal().find("remove " + file().string()), std::string::npos) << left;
  }
  leave("1 2 another-bootpid:[1] " + host);
  EXPECT_EQ(refusal(), "") << "this machine has been started anew since";
  leave(text.substr(0, text.find(' ') + 1) + "7 " + text.substr(system));
  EXPECT_EQ(refusal(), "") << "another process of that number";
}

TEST_P(WorkLockTest, OfAPartExcludesThatPartAndOtherDivisions) {
  const WorkLock lock(folder(), "part-3-of-8.lock");
  EXPECT_EQ(refusal("part-4-of-8.lock"), "");
  EXPECT_NE(refusal("part-3-of-8.lock").find("part-3-of-8 is at work"), std::string::npos);
  EXPECT_NE(refusal("part-3-of-80.lock"), "");
  EXPECT_NE(refusal("part-1-of-2.lock"), "");
  EXPECT_NE(refusal(), "");
  EXPECT_FALSE(fs::exists(file())) << "what is refused leaves no file";
  EXPECT_EQ(holder_of(folder(), "part-3-of-8.lock").rfind("process " + std::to_string(getpid()) + " on ", 0), 0U);
  EXPECT_EQ(holder_of(folder(), "part-4-of-8.lock"), "");
}

TEST_P(WorkLockTest, OfAStudyExcludesParts) {
  const WorkLock lock(folder());
  EXPECT_NE(refusal("part-3-of-8.lock"), "");
}

TEST_P(WorkLockTest, OfAnEndedPartDoesNotExcludeOthers) {
  const std::string text = ended();
  std::ofstream(folder_ / "journal" / "part-3-of-8.lock") << text;
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(refusal("part-1-of-2.lock"), "");
  EXPECT_EQ(refusal("part-3-of-8.lock"), "");
}

TEST_P(WorkLockTest, IsHeldByOneOfManyThatFindOneLeft) {
  leave(ended());
  int done[2], go[2];
  ASSERT_EQ(pipe(done) | pipe(go), 0);
  constexpr int n = 8;
  for (int i = 0; i < n; ++i)
    if (fork() == 0) {
      close(go[1]);
      char mark = 'r';
      try {
        const WorkLock lock(folder());
        mark = 'h';
        if (write(done[1], &mark, 1) != 1) _exit(1);
        if (read(go[0], &mark, 1) != 0) _exit(1);  // holds it until all have tried
      } catch (const InputError&) {
        if (write(done[1], &mark, 1) != 1) _exit(1);
      }
      _exit(0);
    }
  std::string marks;
  for (char mark = 0; marks.size() < n && read(done[0], &mark, 1) == 1;) marks += mark;
  close(go[1]);
  for (int i = 0; i < n; ++i) wait(nullptr);
  EXPECT_EQ(std::count(marks.begin(), marks.end(), 'h'), 1) << marks;
  for (const int end : {done[0], done[1], go[0]}) close(end);
}

INSTANTIATE_TEST_SUITE_P(OnDisks, WorkLockTest, testing::Bool());

}  // namespace work_lock_test
}  // namespace upbead::test
