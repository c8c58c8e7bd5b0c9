// Claim: mean, intervals, quantiles and probabilities of a sample are the textbook's.
#include "upbead/expected/life.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace upbead::test {
namespace statistics_test {

TEST(LifeStatistics, OfFiveLives) {
  const LifeStatistics s = statistics({0., 0.4, 0.2, 0., 1.4});
  EXPECT_NEAR(s.mean, 0.4, 1e-15);
  EXPECT_NEAR(s.standard_error, std::sqrt((0.16 + 0. + 0.04 + 0.16 + 1.) / 4. / 5.), 1e-15);
  EXPECT_NEAR(s.interval[1] - s.mean, 2.7764451051977987 * s.standard_error, 1e-12) << "Student's t, 4 degrees";
  EXPECT_EQ(s.sliding_lives, 3);
  EXPECT_EQ(s.quantiles[1].value, 0.2);
  EXPECT_EQ(s.quantiles[3].value, 1.4);
  EXPECT_EQ(s.exceeded[0].probability, 0.6);
  EXPECT_EQ(s.exceeded[2].probability, 0.2);
}

TEST(LifeStatistics, IntervalsOfAProbabilityAreThoseOfClopperAndPearson) {
  std::vector<double> lives(20, 0.);
  for (std::size_t i = 0; i < 4; ++i) lives[i] = 1.;
  const Exceeded e = statistics(lives).exceeded[0];
  EXPECT_NEAR(e.interval[0], 0.05733400, 1e-7);
  EXPECT_NEAR(e.interval[1], 0.43661402, 1e-7);
}

TEST(LifeStatistics, NothingHappenedIsNotNeverHappens) {
  const Exceeded none = statistics(std::vector<double>(100, 0.)).exceeded[0];
  EXPECT_EQ(none.interval[0], 0.);
  EXPECT_NEAR(none.interval[1], 1. - std::pow(0.025, 0.01), 1e-12);
  EXPECT_EQ(statistics(std::vector<double>(100, 1.)).exceeded[0].interval[1], 1.);
}

TEST(LifeStatistics, NeedTwoLives) {
  EXPECT_THROW(statistics({1.}), std::invalid_argument);
}

}  // namespace statistics_test
}  // namespace upbead::test
