// Claim: a sound file is read on a file system without locks, as some network file systems are, and a file to which
// another program writes is not. The function below stands for both: HDF5 calls it in place of the C library's.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "sample_model.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace locks_test {

int no_locks = 0;  // the reason by which each lock fails; 0: none

/// Locks fail for that reason until the end of the scope.
struct WithoutLocks {
  explicit WithoutLocks(int reason) { no_locks = reason; }
  ~WithoutLocks() { no_locks = 0; }
  WithoutLocks(const WithoutLocks&) = delete;
  WithoutLocks& operator=(const WithoutLocks&) = delete;
};

}  // namespace locks_test
}  // namespace upbead::test

extern "C" int flock(int file, int operation) noexcept {
  if (upbead::test::locks_test::no_locks == 0) return static_cast<int>(syscall(SYS_flock, file, operation));
  errno = upbead::test::locks_test::no_locks;
  return -1;
}

namespace upbead::test {

namespace locks_test {

TEST(Locks, AreNotNeededToRead) {
  const ReducedModelFile made = oscillator();
  const TemporaryFile file(model_file(made));
  for (const int reason : {ENOLCK, ENOSYS, EOPNOTSUPP}) {
    const WithoutLocks there(reason);
    EXPECT_EQ(read_model_file(file.path()).modes.pole, made.modes.pole) << reason;
  }
  const WithoutLocks there(ENOLCK);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  EXPECT_LT(H5Fopen(file.path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), 0) << "HDF5 by itself calls it broken";
}

TEST(Locks, OfAWriterAreHeeded) {
  const TemporaryFile file(model_file(oscillator()));
  const int writer = open(file.path().c_str(), O_RDWR);
  ASSERT_EQ(flock(writer, LOCK_EX | LOCK_NB), 0);
  try {
    read_model_file(file.path());
    FAIL() << "read while another program writes";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("another program writes to it; wait until it has been written"),
              std::string::npos)
        << error.what();
  }
  close(writer);
  EXPECT_NO_THROW(read_model_file(file.path()));
}

}  // namespace locks_test
}  // namespace upbead::test
