// Claims: a block between wedges has the factor of its closed form in clay; with friction the search finds Rankine's
// wedges, so that a block whose thrust is the difference of active and passive thrusts and its own friction has factor
// 1; a block finds a weak layer that circles miss.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

/// Rankine's wedges of the mobilised friction, tan phi_m = tan phi'/F: where F is small the wedge ahead is flatter than
/// 15 degrees, and m_alpha of it is 1/(2 cos(45 - phi_m/2)), never below 0.5.
TEST(SlipBlock, HasSmallFactorsOnFlatWedges) {
  const GroundSoil sand = soil_of(18e3, 0., 35.);
  const GroundSection section = section_of({{sand, {{-90., 4.}, {90., 4.}}}}, -20.);
  for (const double F : {0.15, 0.2368, 0.5}) {
    const double phi_m = std::atan(sand.friction / F), height = 4., weight = 5e5;
    const double active = std::tan(pi / 4. - phi_m / 2.), passive = 1. / active;
    GroundLoads loads;
    loads.strip = {0., 10., weight / 10., weight / 10., 0., 4.};
    loads.strip->horizontal = 0.5 * 18e3 * height * height * (passive * passive - active * active) +
                              (weight + 18e3 * height * 10.) * sand.friction / F;
    const SlipBlock rankine{{-height * active, 0., 10., 10. + height * passive}, {4., 0., 0., 4.}};
    const FigureSafety exact = block_safety(section, loads, rankine, SlipsTo::right, 4000);
    EXPECT_NEAR(exact.factor / F, 1., 1e-3);
    EXPECT_NEAR(exact.least_m, 0.5 / std::cos(pi / 4. - phi_m / 2.), 1e-3);
    const auto found = search_blocks(section, loads, SlipsTo::right, {{-90., -1e-3}, {10., 90.}}, {0., 0.});
    ASSERT_TRUE(found);
    EXPECT_LE(found->safety.factor, 1.001 * F);
    EXPECT_GT(found->safety.factor, 0.7 * F);
    EXPECT_FALSE(found->is_at_limit) << F;
  }
}

/// A caisson on a mound on sand; side = -1: mirrored.
GroundSection mound(double side) {
  const auto seen = [side](Polyline line) {
    if (side > 0.) return line;
    for (auto& point : line) point[0] = -point[0];
    std::reverse(line.begin(), line.end());
    return line;
  };
  return section_of(
      {{soil_of(10e3, 20e3, 38.), seen({{-109., 0.}, {-37., 0.}, {-25., 6.}, {25., 6.}, {38., 0.}, {109., 0.}})},
       {soil_of(10e3, 0., 35.), seen({{-109., -1e-6}, {109., -1e-6}})}},
      -15.);
}

std::optional<FoundBlock> least_of_mound(double side, double horizontal) {
  GroundLoads loads;
  loads.strip = StripLoad{side > 0. ? 2. : -9., side > 0. ? 9. : -2., 4e6 / 7., 4e6 / 7., side * horizontal, 6.};
  const CircleRange range{{-81., loads.strip->from - 1e-3}, {loads.strip->to + 1e-3, 81.}};
  return search_blocks(mound(side), loads, side > 0. ? SlipsTo::right : SlipsTo::left, range, {-30., 6.});
}

TEST(SlipBlock, IsLessSafeUnderMoreLoadAndTheSameWhenMirrored) {
  double before = 1e9;
  for (const double horizontal : {0.5e6, 1e6, 2e6, 2.6e6, 5e6, 8e6}) {
    const auto right = least_of_mound(1., horizontal), left = least_of_mound(-1., horizontal);
    ASSERT_TRUE(right && left);
    EXPECT_NEAR(left->safety.factor / right->safety.factor, 1., 1e-3) << horizontal;
    EXPECT_LT(right->safety.factor, 0.95 * before) << horizontal;
    EXPECT_FALSE(right->is_at_limit);
    before = right->safety.factor;
  }
}

/// Corners moved at random, far and near, about the block that was found.
TEST(SlipBlock, IsNotLessSafeNearTheOneThatWasFound) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const double horizontal : {0.5e6, 2.6e6}) {
    const FoundBlock found = *least_of_mound(1., horizontal);
    const GroundSection section = mound(1.);
    GroundLoads loads;
    loads.strip = StripLoad{2., 9., 4e6 / 7., 4e6 / 7., horizontal, 6.};
    double least = found.safety.factor;
    for (const double step : {3., 0.5, 0.1})
      for (int i = 0; i < 1500; ++i) {
        SlipBlock block = found.block;
        for (double& x : block.x) x += step * normal(random);
        block.y[1] += 0.3 * step * normal(random);
        block.y[2] = block.y[1];
        const bool ordered = block.x[0] > -81. && block.x[0] < 2. && block.x[3] > 9. && block.x[3] < 81. &&
                             std::is_sorted(block.x.begin(), block.x.end());
        if (!ordered) continue;
        block.y[0] = *section.surface(block.x[0]);
        block.y[3] = *section.surface(block.x[3]);
        if (block.y[1] < std::min(block.y[0], block.y[3]))
          least = std::min(least, block_safety(section, loads, block, SlipsTo::right, 400).factor);
      }
    EXPECT_GT(least, 0.995 * found.safety.factor) << horizontal;
  }
}

}  // namespace slip_block_test
}  // namespace upbead::test
