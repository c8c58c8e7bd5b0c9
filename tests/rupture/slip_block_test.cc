// Claims: a block between wedges has the factor of its closed form in clay; with friction the search finds Rankine's
// wedges, so that a block whose thrust is the difference of active and passive thrusts and its own friction has factor
// 1; a block finds a weak layer that circles miss.

#include <gtest/gtest.h>

#include <cmath>

#include "rupture/slip_block.h"
#include "slopes.h"

namespace upbead::test {
namespace slip_block_test {

const double pi = std::acos(-1.);

/// A slope of 1:2 over a weak layer of half a metre.
GroundSection bank(const GroundSoil& soil, double weak_cohesion) {
  return section_of({{soil, {{-60., 8.}, {0., 8.}, {14., 1.}, {60., 1.}}},
                     {soil_of(20e3, weak_cohesion, 0.), {{-60., 0.}, {60., 0.}}},
                     {soil, {{-60., -0.5}, {60., -0.5}}}},
                    -20.);
}

/// Sum of c b/cos2 alpha: 2 c h of each wedge at 45 degrees, c L of the block, over gamma (h1^2 - h2^2)/2.
TEST(SlipBlock, InClayHasTheFactorOfItsClosedForm) {
  const GroundSection section = bank(soil_of(20e3, 30e3, 0.), 10e3);
  const SlipBlock block{{-20., -12., 19., 20.}, {8., 0., 0., 1.}};
  const FigureSafety found = block_safety(section, {}, block, SlipsTo::right, 30000);
  const double resists = 2. * 30e3 * 8. + 2. * 30e3 * 1. + 10e3 * 31., drives = 20e3 * (64. - 1.) / 2.;
  EXPECT_NEAR(found.factor, resists / drives, 1e-3 * resists / drives);
  EXPECT_EQ(block_safety(section, {}, block, SlipsTo::left, 300).why, NoFactor::nothing_drives);
}

TEST(SlipBlock, FindsRankinesWedges) {
  const GroundSoil sand = soil_of(18e3, 0., 32.);
  const GroundSection section = section_of({{sand, {{-60., 4.}, {60., 4.}}}}, -20.);
  const double active = std::pow(std::tan(pi / 4. - 16. * pi / 180.), 2.), passive = 1. / active;
  GroundLoads loads;
  const double weight = 5e5, height = 4.;
  loads.strip = {0., 10., weight / 10., weight / 10., 0., 4.};
  // all of the strip is over the block where its ends are fixed: active wedge up to x = 0, passive one from x = 10
  const double friction = (weight + 18e3 * height * 10.) * sand.friction;
  loads.strip->horizontal = 0.5 * 18e3 * height * height * (passive - active) + friction;
  const double run_active = height * std::tan(pi / 4. - 16. * pi / 180.);
  const double run_passive = height / std::tan(pi / 4. - 16. * pi / 180.);
  const SlipBlock block{{-run_active, 0., 10., 10. + run_passive}, {4., 0., 0., 4.}};
  EXPECT_NEAR(block_safety(section, loads, block, SlipsTo::right, 4000).factor, 1., 1e-3);
}

TEST(SlipBlock, FindsAWeakLayerThatCirclesMiss) {
  const GroundSection section = bank(soil_of(20e3, 5e3, 38.), 5e3);
  const CircleRange range{{-60., -1e-3}, {14., 60.}};
  const auto block = search_blocks(section, {}, SlipsTo::right, range, {-4., 0.9});
  const auto circles = search_circles(section, {}, SlipsTo::right, range);
  ASSERT_TRUE(block && !circles.family.empty());
  EXPECT_LT(block->block.y[1], 0.);
  EXPECT_GT(block->block.y[1], -0.5);
  EXPECT_LT(block->safety.factor, 0.97 * circles.family[0].safety.factor);
}

}  // namespace slip_block_test
}  // namespace upbead::test
