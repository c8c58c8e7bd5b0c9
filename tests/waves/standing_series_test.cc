// Claim: the residual that a series reports for the conditions at the surface is that of the worse condition at its
// worst place.

#include "waves/standing_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace upbead {
namespace standing_series_test {

constexpr double pi = 3.14159265358979323846;

TEST(StandingSeries, LeavesOfTheWorseConditionWhatItSays) {
  // by kh and H/h: the kinematic condition is the worse one in the first wave, the dynamic one in the second
  for (const auto& [kh, height] : {std::pair(0.7, 0.45), {2., 0.25}}) {
    const auto series = solve_standing(height, kh, 1e-4, 16);
    ASSERT_TRUE(series);
    double kinematic = 0., dynamic = 0.;
    constexpr int n = 60;
    for (int i = 0; i <= n; ++i) {
      const StandingInstant instant = series->at(0.5 * pi * i / n);
      for (int j = 0; j <= n; ++j) {
        const SurfaceConditions left = surface_conditions(instant, pi * j / n);
        kinematic = std::max(kinematic, std::abs(left.kinematic) / series->frequency());
        dynamic = std::max(dynamic, std::abs(left.dynamic));
      }
    }
    const double worse = std::max(kinematic, dynamic) / series->swing();
    EXPECT_NEAR(series->residual / worse, 1., 0.03) << "kh " << kh;
    EXPECT_EQ(kinematic > dynamic, kh < 1.);
  }
}

}  // namespace standing_series_test
}  // namespace upbead
