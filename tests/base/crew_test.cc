// Claims: a crew calls the work once for every number, whatever the number of threads, again and again; an exception
// in one call reaches the caller, and the crew can be used again.

#include "base/crew.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace upbead {
namespace crew_test {

TEST(Crew, DoesEveryPieceOnce) {
  for (const int threads : {1, 2, 5}) {
    Crew crew(threads);
    EXPECT_EQ(crew.size(), threads);
    for (const int n : {0, 1, 3, 100, 1000}) {
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(n));
      for (int again = 0; again < 20; ++again) crew.share(n, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
      for (const auto& count : calls) EXPECT_EQ(count, 20);
    }
  }
}

TEST(Crew, ThrowsWhatAPieceThrowsAndGoesOn) {
  Crew crew(3);
  for (int again = 0; again < 50; ++again)
    EXPECT_THROW(crew.share(100,
                            [](int i) {
                              if (i == 57) throw std::runtime_error("here");
                            }),
                 std::runtime_error);
  std::atomic<int> n{0};
  crew.share(40, [&](int) { ++n; });
  EXPECT_EQ(n, 40);
}

TEST(Crew, IsAsLargeAsIsAllowed) {
  EXPECT_GE(Crew().size(), 1);
  setenv("OMP_NUM_THREADS", "1", 1);
  EXPECT_EQ(Crew().size(), 1);
}

}  // namespace crew_test
}  // namespace upbead
