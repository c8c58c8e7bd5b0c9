// Claims: a column of a section has its soils from the top downwards; weights are those of its layers, submerged below
// still water; what is no soil between soils is told.

#include <gtest/gtest.h>

#include <cmath>

#include "slopes.h"

namespace upbead::test {
namespace section_test {

GroundSoil soil(double weight, double submerged) {
  GroundSoil s;
  s.weight = weight;
  s.submerged = submerged;
  return s;
}

const GroundSection& two_layers() {
  static const GroundSection section = section_of(
      {{soil(18., 10.), {{0., 4.}, {10., 4.}, {20., 8.}}}, {soil(20., 11.), {{0., 1.}, {20., 3.}}}}, -2., 5.);
  return section;
}

TEST(GroundSection, HasItsSoilsFromTheTop) {
  const auto column = two_layers().column(15.);
  ASSERT_TRUE(column);
  ASSERT_EQ(column->layers.size(), 3u);
  EXPECT_DOUBLE_EQ(column->surface(), 6.);
  EXPECT_DOUBLE_EQ(column->layers[1].top, 2.5);
  EXPECT_EQ(two_layers().soil_at(*column, 2.6), &two_layers().soils()[0]);
  EXPECT_EQ(two_layers().soil_at(*column, 2.4), &two_layers().soils()[1]);
  EXPECT_EQ(two_layers().soil_at(*column, -3.), nullptr);
  EXPECT_EQ(two_layers().soil_at(*column, 7.), nullptr);
  EXPECT_TRUE(two_layers().column(0.) && two_layers().column(20.));
  EXPECT_FALSE(two_layers().column(-0.1) || two_layers().column(20.1));
}

TEST(GroundSection, WeighsLayersAndWhatTheWaterBears) {
  const auto column = *two_layers().column(15.);
  const GroundSection::Weight found = two_layers().weight_above(column, 0.);
  EXPECT_DOUBLE_EQ(found.force, 18. * 1. + 10. * 2.5 + 11. * 2.5);
  EXPECT_DOUBLE_EQ(found.moment, 18. * 1. * 5.5 + 10. * 2.5 * 3.75 + 11. * 2.5 * 1.25);
}

TEST(GroundSection, TellsWhatIsNoSoilBetweenSoils) {
  const GroundSection section(
      {soil(1., 1.)},
      {{{0., 1.}, {3., 3.}, 0}, {{0., 1.}, {2., 2.}, no_soil}, {{0., 1.}, {1., 1.}, 0}, {{0., 1.}, {0., 0.}, no_soil}});
  const auto column = section.column(0.5);
  ASSERT_TRUE(column);
  EXPECT_FALSE(column->is_whole);
  EXPECT_TRUE(two_layers().column(3.)->is_whole);
  EXPECT_EQ(section.soil_at(*column, 0.5), nullptr);
}

}  // namespace section_test
}  // namespace upbead::test
