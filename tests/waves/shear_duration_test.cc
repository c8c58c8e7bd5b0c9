// Claim: tau_0F and k are those of eqs. (8)-(11), and remain valid numbers where alpha* is not positive or H/h above
// 0.8.

#include "upbead/waves/goda.h"

#include <gtest/gtest.h>

#include <utility>

namespace upbead {
namespace shear_duration_test {

TEST(DurationFactor, HasItsValues) {
  const DurationFactor k;
  for (const auto& [alpha, value] : {std::pair(0.001, 0.789), {0.01, 0.639}, {0.05, 0.505}, {0.1, 0.444}, {0.5, 0.304}})
    EXPECT_NEAR(k(alpha), value, 5.01e-4);
  EXPECT_EQ(k(1.), 0.25);
  EXPECT_NEAR(k(2.), 0.2009, 5e-5);
}

TEST(DurationFactor, IsOneWhereNothingIsImpulsive) {
  const DurationFactor k;
  EXPECT_EQ(k(0.), 1.);
  EXPECT_EQ(k(-0.3), 1.) << "pow of a negative number would be NaN";
}

TEST(DurationFactor, TakesOtherExponents) {
  EXPECT_DOUBLE_EQ((DurationFactor{1., 1.}(0.5)), 1. / 1.5);
  EXPECT_EQ((DurationFactor{0.3, 0.}(0.5)), 1.);
}

TEST(StandingDuration, IsEquation11) {
  EXPECT_DOUBLE_EQ(standing_duration(8., 15., 12.), (0.5 - 8. / 120.) * 12.);
  EXPECT_DOUBLE_EQ(standing_duration(0., 15., 12.), 6.);
}

TEST(StandingDuration, KeepsItsLastValueBeyondEightTenths) {
  EXPECT_DOUBLE_EQ(standing_duration(12., 15., 12.), 0.4 * 12.);
  EXPECT_DOUBLE_EQ(standing_duration(30., 15., 12.), 0.4 * 12.);
}

TEST(StandingDuration, CannotBeAsShortAsThePaperSays) {
  // The text of the paper gives 0.1 to 0.2 s for the model's T = 3.04 s; by eqs. (8)-(11) it is at least 0.244 s, as
  // alpha* never exceeds 2.
  EXPECT_NEAR(DurationFactor()(2.) * standing_duration(1., 1., 3.04), 0.244, 5e-4);
}

}  // namespace shear_duration_test
}  // namespace upbead
