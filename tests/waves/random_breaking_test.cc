// Claim: design heights by random breaking are those of Goda's examples, and of shoaling alone offshore.

#include "upbead/waves/wave_heights.h"

#include <gtest/gtest.h>

namespace upbead {
namespace {

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

/// Computed once by another program from the same formulas; each row has other branches at work.
TEST(RandomBreaking, HoldsBranchByBranch) {
  struct Row {
    Approach approach;
    double significant, highest;
  };
  const Row rows[] = {{{6.3, 11.4, 5., 0.01}, 3.3848, 4.6332},    // both kept low by the depth
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

}  // namespace
}  // namespace upbead
