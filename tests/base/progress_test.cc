// Claim: the progress line shows per cent and time left; nothing is written where the output is not a terminal.
#include "base/progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace upbead {
namespace progress_test {

TEST(ProgressLine, TellsPercentAndTimeLeft) {
  EXPECT_EQ(progress_line("marching", 0., 0.), "marching: 0 %");
  EXPECT_EQ(progress_line("marching", 0.425, 0.5), "marching: 42 %");
  EXPECT_EQ(progress_line("marching", 0.5, 12.), "marching: 50 %, 12 s left");
  EXPECT_EQ(progress_line("marching", 0.25, 100.), "marching: 25 %, 5 min left");
  EXPECT_EQ(progress_line("marching", 0.1, 3600.), "marching: 10 %, 9 h left");
  EXPECT_EQ(progress_line("marching", 1.5, 10.), "marching: 100 %, 0 s left");
}

TEST(Progress, IsSilentInAFile) {
  testing::internal::CaptureStderr();
  {
    Progress progress("marching");
    progress.update(0.1);
    progress.update(1.);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Stopwatch, Runs) {
  const Stopwatch watch;
  const double first = watch.seconds();
  EXPECT_GE(first, 0.);
  EXPECT_GE(watch.seconds(), first);
}

TEST(Progress, PartsOfTheWholeFollowEachOther) {
  std::vector<double> seen;
  const std::function<void(double)> whole = [&seen](double done) { seen.push_back(done); };
  const auto first = part_of(whole, 0., 0.25), second = part_of(whole, 0.25, 1.);
  for (const double done : {0., 0.5, 1.}) first(done);
  for (const double done : {0., 0.5, 1.}) second(done);
  EXPECT_EQ(seen, (std::vector<double>{0., 0.125, 0.25, 0.25, 0.625, 1.}));
  EXPECT_FALSE(part_of({}, 0., 1.));
}

}  // namespace progress_test
}  // namespace upbead
