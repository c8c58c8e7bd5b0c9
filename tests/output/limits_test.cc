// Claims: a check is held to the limit that it names, whatever it is called; limits that none judges are found by that
// alone; a capacity that is no limit is none that was not judged.
#include "output/limits.h"

#include <gtest/gtest.h>

namespace upbead {
namespace limits_test {

Check called(const std::string& name, double demand) {
  return check_of(FailureMode::sliding_distance, name, "m", demand, "", "");
}

Limits given() {
  Limits limits;
  limits.sliding = 0.3;
  limits.tilt = 0.01;
  return limits;
}

TEST(Limits, ACheckWithAnotherNameIsStillJudged) {
  const Check check = held_to(called("how far it goes", 0.5), given(), &Limits::sliding);
  EXPECT_EQ(check.limit, "sliding");
  EXPECT_EQ(check.holds, false);
  const Checks left = unjudged_limits(given(), {check}, false);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].limit, "tilt");
  EXPECT_EQ(left[0].mode, FailureMode::tilt);
  EXPECT_EQ(verdict_of(left, {}).unjudged, 1);
}

TEST(Limits, ANameJudgesNothing) {
  const Checks checks{at_most(called("sliding distance", 0.1), 0.3), at_most(called("tilt", 0.1), 1.)};
  EXPECT_EQ(unjudged_limits(given(), checks, false).size(), 2U);
}

TEST(Limits, ACheckThatSaysWhyItWasNotMadeStandsForItsLimit) {
  const Check check = not_checked(held_to(called("it", 0.5), given(), &Limits::sliding), "nobody knows");
  EXPECT_EQ(unjudged_limits(given(), {check}, false).size(), 1U);
  EXPECT_EQ(verdict_of({check}, {}).unjudged, 1);
  const Check friction = not_checked(at_most(called("it", 0.5), 2.), "nobody knows");
  EXPECT_EQ(verdict_of({friction}, {}).unjudged, 0) << "its capacity is no limit";
}

TEST(Limits, TheLimitSaysWhatMustNotFallBelowIt) {
  Limits limits;
  EXPECT_EQ(held_to(called("F", 1.1), limits, &Limits::sliding_factor, 1.).holds, true);
  EXPECT_FALSE(held_to(called("F", 1.1), limits, &Limits::sliding_factor).holds);
  limits.sliding_factor = 1.2;
  EXPECT_EQ(held_to(called("F", 1.1), limits, &Limits::sliding_factor, 1.).holds, false);
  limits.sliding = 1.2;
  EXPECT_EQ(held_to(called("S", 1.1), limits, &Limits::sliding).holds, true);
}

TEST(Checks, DigitsTellDemandFromCapacityAndAMarginFromOne) {
  const Check just = at_most(called("S", 0.02774), 0.027737);
  EXPECT_EQ(text_of(just), "S: 27.74 mm against 27.737 mm: DOES NOT HOLD, margin 0.9999");
  const Check factor = at_least_as(check_of(FailureMode::overturning, "F", "", 1.1969999, "", ""), 1.197);
  EXPECT_EQ(text_of(factor), "F: 1.1969999 against at least 1.197: DOES NOT HOLD, margin 0.9999999");
  EXPECT_EQ(text_of(at_most(called("S", 0.2), 0.2)), "S: 0.2 m against 0.2 m: holds, margin 1");
}

}  // namespace limits_test
}  // namespace upbead
