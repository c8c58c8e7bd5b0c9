// Claim: memory that is given back goes back to the system while PETSc runs, whose libraries would have malloc keep it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "upbead/algebra/petsc_session.h"

namespace memory_test {

/// Memory of this process in use (bytes); 0 where the system does not tell.
long in_use() {
  std::ifstream file("/proc/self/statm");
  long all = 0, resident = 0;
  file >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

TEST(Memory, GoesBackToTheSystem) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer's own malloc keeps freed memory for a while";
#endif
  if (in_use() == 0) GTEST_SKIP() << "/proc/self/statm is not there";
  constexpr long size = 200 << 20;
  const upbead::PetscSession petsc;
  const long before = in_use();
  {
    const std::vector<char> large(size, 1);
    ASSERT_GT(in_use() - before, size / 2);
  }
  EXPECT_LT(in_use() - before, size / 2);
}

}  // namespace memory_test
