// Claim: a folder has one study at a time, also on a file system without locks; what a process has left that was
// killed, at whatever moment, keeps nobody out.
#include "study/study_lock.h"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "upbead/base/error.h"

namespace {
bool has_locks = true;
}

/// Stands for the one of the C library: of a file system with locks, or of one without.
extern "C" int flock(int descriptor, int operation) {
  if (has_locks) return static_cast<int>(syscall(SYS_flock, descriptor, operation));
  errno = ENOLCK;
  return -1;
}

namespace upbead::test {
namespace study_lock_test {

namespace fs = std::filesystem;

class StudyLockTest : public testing::TestWithParam<bool> {
 protected:
  StudyLockTest() : folder_(fs::temp_directory_path() / ("upbead-lock-" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    has_locks = GetParam();
  }
  ~StudyLockTest() override {
    has_locks = true;
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
  std::string refusal() const {
    try {
      const StudyLock lock(folder());
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  }

  fs::path folder_;
};

TEST_P(StudyLockTest, KeepsASecondOneOutWithPlaceAndCure) {
  {
    const StudyLock lock(folder());
    const std::string refused = refusal();
    EXPECT_NE(refused.find(folder()), std::string::npos);
    EXPECT_NE(refused.find("process " + std::to_string(getpid())), std::string::npos) << refused;
    EXPECT_NE(refused.find("--out DIR"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(file()));
  EXPECT_EQ(refusal(), "");
}

TEST_P(StudyLockTest, OfAProcessThatWasKilledKeepsNobodyOut) {
  const pid_t child = fork();
  if (child == 0) {
    const StudyLock lock(folder());
    _exit(0);  // without its destructor
  }
  waitpid(child, nullptr, 0);
  EXPECT_NE(text(), "");
  EXPECT_EQ(refusal(), "");
  for (const std::string& left : {std::string(), std::string("12"), std::string("no owner at all\n")}) {
    leave(left);
    fs::last_write_time(file(), fs::file_time_type::clock::now() - std::chrono::minutes(2));
    EXPECT_EQ(refusal(), "") << left;
  }
}

TEST_P(StudyLockTest, OfAProcessThatMayRunElsewhereIsToldWhereThereAreNoLocks) {
  std::string own;
  {
    const StudyLock lock(folder());
    own = text();
  }
  const std::size_t system = own.find(' ', own.find(' ') + 1) + 1, host = own.rfind(' ') + 1;
  leave("1 2 " + std::string("another-boot") + "pid:[1] elsewhere\n");
  EXPECT_EQ(refusal().find("remove " + file().string()) != std::string::npos, !GetParam());
  leave("1 2 another-bootpid:[1] " + own.substr(host));
  EXPECT_EQ(refusal(), "") << "this machine has been started anew since";
  leave(own.substr(0, own.find(' ') + 1) + "7 " + own.substr(system));
  EXPECT_EQ(refusal(), "") << "another process of that number";
}

TEST_P(StudyLockTest, IsHeldByOneOfManyThatFindOneLeft) {
  leave("1 2 another-bootpid:[1] x\n");
  std::string own;
  if (!GetParam()) {
    fs::remove(file());
    {
      const StudyLock lock(folder());
      own = text();
    }
    leave("4194304 1 " + own.substr(own.find(' ', own.find(' ') + 1) + 1));  // no process has that number
  }
  std::vector<pid_t> children;
  for (int i = 0; i < 8; ++i)
    if (const pid_t child = fork(); child != 0) {
      children.push_back(child);
    } else {
      try {
        const StudyLock lock(folder());
        usleep(1000000);
        _exit(0);
      } catch (const InputError&) {
        _exit(1);
      }
    }
  int held = 0;
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    held += WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 1 : 0;
  }
  EXPECT_EQ(held, 1);
}

INSTANTIATE_TEST_SUITE_P(OnDisks, StudyLockTest, testing::Bool());

}  // namespace study_lock_test
}  // namespace upbead::test
