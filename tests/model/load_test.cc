// Claim: the distribution of a load over the height, and the duration of a measured history.
#include "upbead/model/load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace upbead {
namespace load_test {

TEST(Intensity, IsLinearBetweenAndZeroBeyond) {
  Load load;
  EXPECT_EQ(intensity(load, 3.), 1.);
  load.shape = {{6., 1.}, {16., 2.}, {26., 0.}};
  EXPECT_EQ(intensity(load, 5.99), 0.);
  EXPECT_EQ(intensity(load, 6.), 1.);
  EXPECT_DOUBLE_EQ(intensity(load, 11.), 1.5);
  EXPECT_DOUBLE_EQ(intensity(load, 21.), 1.);
  EXPECT_EQ(intensity(load, 26.), 0.);
  EXPECT_EQ(intensity(load, 27.), 0.);
}

TEST(SampledDuration, OfATriangleIsTwiceItsShorterFlank) {
  EXPECT_DOUBLE_EQ(sampled_duration({0., 0.02, 0.1}, {0., 5., 0.}, 1.), 0.04);
}

TEST(SampledDuration, DoesNotDependOnTheSampling) {
  for (const int n : {20, 200, 2000}) {
    std::vector<double> time, value;
    for (int i = 0; i <= n; ++i) {
      time.push_back(0.1 * i / n);
      value.push_back(std::sin(M_PI * i / n));
    }
    // 2 peak / (peak pi / 0.1); the first chord is flatter than the sine at its start by (pi/n)^2/6
    EXPECT_NEAR(sampled_duration(time, value, 1.), 0.2 / M_PI, 0.005 * 0.2 / M_PI) << n;
  }
}

TEST(SampledDuration, IsZeroWhereTheRecordJumps) {
  EXPECT_EQ(sampled_duration({0., 1.}, {1., 0.}, 2.), 0.);
  EXPECT_EQ(sampled_duration({0., 1.}, {0., 1.}, 2.), 0.);
  EXPECT_DOUBLE_EQ(sampled_duration({0., 1.}, {0., 1.}, 1.), 2.) << "the jump comes after the run";
  EXPECT_EQ(sampled_duration({0., 1.}, {0., 0.}, 1.), std::numeric_limits<double>::infinity());
}

}  // namespace load_test
}  // namespace upbead
