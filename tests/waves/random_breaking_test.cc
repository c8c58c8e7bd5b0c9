// Claim: design heights by random breaking are those of Goda's examples, and of shoaling alone offshore; the sea
// state that gives H_1/3 at the wall is found, and its highest breaker is that of single waves.

#include "upbead/waves/wave_heights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace upbead {
namespace random_breaking_test {

TEST(RandomBreaking, GivesGodasExample) {
  const DesignHeights heights = design_heights({6.3, 11.4, 10.1, 0.01}, 9.81);
  EXPECT_NEAR(heights.significant, 5.796, 5e-4);
  EXPECT_NEAR(heights.highest, 8.050, 5e-4);
}

TEST(RandomBreaking, ShoalsAsInTheBook) {
  EXPECT_NEAR(shoaling({4.5, 12., 8., 0.01}, 9.81), 1.24, 5e-3);
}

TEST(RandomBreaking, IsShoalingAloneInDeepWater) {
  const Approach deep{5., 8., 50., 0.02};
  ASSERT_GT(deep.depth / deep_water_wavelength(deep.period, 9.81), 0.2);
  const DesignHeights heights = design_heights(deep, 9.81);
  EXPECT_DOUBLE_EQ(heights.significant, shoaling(deep, 9.81) * 5.);
  EXPECT_DOUBLE_EQ(heights.highest, 1.8 * heights.significant);
}

/// Computed once by another program from the same formulas; each row uses other branches of the formulas.
TEST(RandomBreaking, HoldsBranchByBranch) {
  struct Row {
    Approach approach;
    double significant, highest;
  };
  const Row rows[] = {{{6.3, 11.4, 5., 0.01}, 3.3848, 4.6332},    // both limited by the depth
                      {{6.3, 11.4, 8., 0.05}, 5.9574, 8.7620},    // the same on a steep bed
                      {{6.3, 11.4, 9., 0.05}, 6.2218, 9.5742},    // H_1/3 by beta_max of the slope, above 0.92
                      {{6.3, 11.4, 9.5, 0.01}, 5.7960, 7.6569},   // H_1/3 by 0.92 H_0'
                      {{2., 14., 5., 0.05}, 3.1036, 5.1403},      // both by beta_max of low steepness
                      {{2., 14., 6., 0.05}, 2.8634, 5.1403},      // H_1/3 by shoaling
                      {{9., 10., 22., 0.01}, 8.2800, 14.8500},    // 0.92 and 1.65 H_0'
                      {{9., 10., 31.5, 0.01}, 8.3018, 14.9433}};  // h/L_0 = 0.202: shoaling alone, Hmax above 1.65 H_0'
  for (const Row& row : rows) {
    const DesignHeights heights = design_heights(row.approach, 9.81);
    EXPECT_NEAR(heights.significant, row.significant, 5.01e-5) << row.approach.depth;
    EXPECT_NEAR(heights.highest, row.highest, 5.01e-5) << row.approach.depth;
  }
}

TEST(RandomBreaking, IsKeptLowByTheDepth) {
  double last = 1e9;
  for (const double h : {12., 8., 5., 3.}) {
    const DesignHeights heights = design_heights({6.3, 11.4, h, 0.01}, 9.81);
    EXPECT_LT(heights.significant, last);
    EXPECT_GT(heights.highest, heights.significant);
    EXPECT_LT(heights.highest, 1.8 * heights.significant) << "the highest waves have broken";
    last = heights.significant;
  }
}

TEST(RandomBreaking, LetsHigherWavesInOnASteeperBed) {
  EXPECT_GT(design_heights({6.3, 11.4, 6., 0.05}, 9.81).highest, design_heights({6.3, 11.4, 6., 0.01}, 9.81).highest);
}

TEST(RandomBreaking, TheHighestBreakerIsHmaxWhereTheDepthKeepsItLow) {
  const DesignHeights low = design_heights({6.3, 11.4, 5., 0.01}, 9.81),
                      high = design_heights({9., 10., 22., 0.01}, 9.81);
  EXPECT_EQ(low.breaker, low.highest);
  EXPECT_GT(high.breaker, high.highest) << "1.65 H_0' is how high waves get, not what the depth lets through";
  EXPECT_EQ(design_heights({9., 10., 31.5, 0.01}, 9.81).breaker, HUGE_VAL) << "h/L_0 = 0.202";
}

/// Goda's (1975) criterion of single waves, H_b = A L_0 (1 - exp(-1.5 pi h/L_0 (1 + 15 tan(theta)^(4/3)))): at A =
/// 0.18, here with the depth h_b, it is the height above which every random wave has broken. In shallower water
/// set-up and surf beat matter, which the criterion leaves out.
TEST(RandomBreaking, TheHighestBreakerIsNearThatOfSingleWaves) {
  const double L0 = deep_water_wavelength(12., 9.81);
  int compared = 0;
  for (const double slope : {0.01, 0.02, 0.03, 0.05})
    for (const double depth : {0.05 * L0, 0.07 * L0, 0.1 * L0, 0.13 * L0})
      for (const double steepness : {0.02, 0.03, 0.04, 0.06}) {
        const DesignHeights heights = design_heights({steepness * L0, 12., depth, slope}, 9.81);
        if (heights.highest < heights.breaker) continue;
        const double depth_b = depth + 5. * heights.significant * slope;
        const double single =
            0.18 * L0 * (1. - std::exp(-1.5 * M_PI * depth_b / L0 * (1. + 15. * std::pow(slope, 4. / 3.))));
        EXPECT_GT(heights.breaker, 0.97 * single) << slope << " " << depth << " " << steepness;
        EXPECT_LT(heights.breaker, 1.13 * single) << slope << " " << depth << " " << steepness;
        ++compared;
      }
  EXPECT_GE(compared, 16);
}

TEST(SeaBefore, IsFoundAgain) {
  const Approach approaches[] = {
      {6.3, 11.4, 5., 0.01}, {6.3, 11.4, 9., 0.05},   {6.3, 11.4, 9.5, 0.01}, {2., 14., 6., 0.05}, {9., 10., 22., 0.01},
      {9., 10., 31.5, 0.01}, {0.02, 14., 12., 0.001}, {13.5, 12., 12., 0.02}, {2., 14., 5., 0.05}, {2., 20., 1., 0.02}};
  for (const Approach& a : approaches) {
    const DesignHeights heights = design_heights(a, 9.81);
    const SeaBefore found = sea_before(heights.significant, {0., a.period, a.depth, a.bed_slope}, 9.81);
    EXPECT_TRUE(found.reaches);
    EXPECT_NEAR(found.deep_water_height, a.deep_water_height, 1e-12 * a.deep_water_height) << a.depth;
    EXPECT_NEAR(found.heights.highest, heights.highest, 1e-13 * heights.highest) << a.depth;
  }
}

TEST(SeaBefore, OfAHeightThatNoSeaBringsIsTheSteepest) {
  const SeaBefore found = sea_before(9., {0., 12., 12., 0.02}, 9.81);
  EXPECT_FALSE(found.reaches);
  EXPECT_NEAR(1.8 * found.deep_water_height, 0.142 * deep_water_wavelength(12., 9.81), 1e-12) << "Miche";
  EXPECT_LT(found.heights.significant, 9.);
  EXPECT_TRUE(sea_before(0.999999 * found.heights.significant, {0., 12., 12., 0.02}, 9.81).reaches);
  EXPECT_THROW(sea_before(0., {0., 12., 12., 0.02}, 9.81), std::invalid_argument);
}

}  // namespace random_breaking_test
}  // namespace upbead
