// Claim: exceedance, its density and its inverse are consistent, with and without a cut or a limit; waves beyond a
// cut are set aside, those above a limit arrive with its height.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "upbead/expected/sliding_law.h"

namespace upbead::test {

namespace rayleigh_test {

const RayleighHeights limited(6., RayleighHeights::no_cut, 11.7);

TEST(RayleighHeights, ExceedanceIsThatOfLonguetHiggins) {
  const RayleighHeights heights(6.);
  EXPECT_DOUBLE_EQ(heights.exceedance(0.), 1.);
  EXPECT_DOUBLE_EQ(heights.exceedance(6.), std::exp(-2.));
  EXPECT_DOUBLE_EQ(heights.exceedance(1.8 * 6.), std::exp(-2. * 1.8 * 1.8));
}

TEST(RayleighHeights, SignificantHeightIsTheMeanOfTheHighestThird) {
  const RayleighHeights heights(6.);
  double mean = 0.;
  const int n = 100000;
  for (int i = 0; i < n; ++i) mean += heights.height((i + 0.5) / n / 3.) / n;
  EXPECT_NEAR(mean, 6., 0.01) << "1.4157 / sqrt(2) = 1.0011 times the significant height";
}

TEST(RayleighHeights, DensityIsTheSlopeOfTheExceedance) {
  for (const RayleighHeights& heights : {RayleighHeights(6.), RayleighHeights(6., 2.), limited})
    for (const double H : {0.5, 3., 7., 11.5}) {
      const double slope = (heights.exceedance(H - 1e-4) - heights.exceedance(H + 1e-4)) / 2e-4;
      EXPECT_NEAR(heights.density(H), slope, 1e-7 * heights.density(3.)) << H;
    }
}

TEST(RayleighHeights, HeightIsTheInverseOfTheExceedance) {
  for (const RayleighHeights& heights : {RayleighHeights(6.), RayleighHeights(6., 2.), limited})
    for (const double H : {0.5, 3., 7., 11.5}) EXPECT_NEAR(heights.height(heights.exceedance(H)), H, 1e-10);
}

TEST(RayleighHeights, WavesBeyondTheCutAreSetAside) {
  const RayleighHeights whole(6.), cut(6., 2.);
  const double beyond = std::exp(-8.);
  EXPECT_EQ(cut.highest(), 12.);
  EXPECT_EQ(cut.exceedance(12.), 0.);
  EXPECT_EQ(cut.density(12.1), 0.);
  EXPECT_DOUBLE_EQ(cut.density(9.), whole.density(9.)) << "not scaled up";
  EXPECT_NEAR(cut.exceedance(9.), whole.exceedance(9.) - beyond, 1e-16);
  EXPECT_NEAR(cut.height(0.), 12., 1e-12);
}

TEST(RayleighHeights, WavesAboveTheLimitArriveWithItsHeight) {
  const double above = std::exp(-2. * std::pow(11.7 / 6., 2));
  EXPECT_EQ(limited.highest(), 11.7);
  EXPECT_DOUBLE_EQ(limited.at_limit(), above);
  EXPECT_DOUBLE_EQ(limited.taken(), above);
  EXPECT_EQ(limited.exceedance(0.), 1.) << "none is lost";
  EXPECT_NEAR(limited.exceedance(11.7 - 1e-9), above, 1e-11);
  EXPECT_EQ(limited.exceedance(11.7), 0.);
  EXPECT_EQ(limited.height(0.9 * above), 11.7);
  EXPECT_EQ(limited.height(0.), 11.7);
  EXPECT_EQ(RayleighHeights(6., 1.7).taken(), std::exp(-2. * 1.7 * 1.7));
  EXPECT_EQ(RayleighHeights(6., 1.7).at_limit(), 0.);
  EXPECT_EQ(RayleighHeights(6.).taken(), 0.);
}

/// Goda (1975): of waves with H between 2/3 of the limit and the limit, a share (3 H / limit - 2) breaks and is left
/// out; higher waves are all left out; the remaining distribution is scaled up.
TEST(RayleighHeights, AboveAnyHeightBreakingLeavesNoFewerWavesThanInGodasModel) {
  for (const double limit : {4., 8., 11.7}) {
    const RayleighHeights waves(6.), broken(6., RayleighHeights::no_cut, limit);
    const int n = 20000;
    std::vector<double> below{0.};
    for (int i = 0; i < n; ++i) {
      const double H = limit * (i + 0.5) / n;
      below.push_back(below.back() + waves.density(H) * std::min(3. * (1. - H / limit), 1.) * limit / n);
    }
    for (std::size_t i = 0; i < n; i += 100) {
      const double H = limit * static_cast<double>(i) / n;
      EXPECT_LE(1. - below[i] / below.back(), broken.exceedance(H) + 1e-12) << H << " of " << limit;
    }
  }
}

TEST(RayleighHeights, ACutBelowTheLimitLeavesNothingToBreak) {
  const RayleighHeights both(6., 1.7, 11.7), other(6., 2.2, 11.7);
  EXPECT_EQ(both.highest(), 1.7 * 6.);
  EXPECT_EQ(both.at_limit(), 0.);
  EXPECT_DOUBLE_EQ(other.at_limit(), limited.at_limit() - std::exp(-2. * 2.2 * 2.2));
  EXPECT_DOUBLE_EQ(other.taken(), limited.at_limit());
}

TEST(RayleighHeights, RefuseWhatIsNoSea) {
  EXPECT_THROW(RayleighHeights(0.), std::invalid_argument);
  EXPECT_THROW(RayleighHeights(std::nan("")), std::invalid_argument);
  EXPECT_THROW(RayleighHeights(6., 0.), std::invalid_argument);
  EXPECT_THROW(RayleighHeights(6., 2., 0.), std::invalid_argument);
}

}  // namespace rayleigh_test
}  // namespace upbead::test
