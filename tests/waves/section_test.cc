// Claim: contradictions in a section are reported, and a section is adapted to the water level.

#include "upbead/waves/goda.h"

#include <gtest/gtest.h>

#include "sections.h"

namespace upbead::test {
namespace section_test {

TEST(Section, SoundOnesHaveNoFaults) {
  EXPECT_TRUE(diagnose(goda_section()).empty());
  EXPECT_TRUE(diagnose(sliding_section()).empty());
}

TEST(Section, ContradictionsAreTold) {
  Section s = goda_section();
  s.submerged_weight = s.weight;
  s.centroid = 15.;
  const auto list = diagnose(s).list();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].place.key, "submerged_weight");
  EXPECT_EQ(list[1].place.key, "centroid");
}

TEST(Section, FollowsTheWaterLevel) {
  const Section s = goda_section(), high = at_water_level(s, Water(), 1.5);
  EXPECT_DOUBLE_EQ(high.water_depth, 11.6);
  EXPECT_DOUBLE_EQ(high.foundation_depth, 8.6);
  EXPECT_DOUBLE_EQ(high.berm_depth, 7.1);
  EXPECT_DOUBLE_EQ(high.crest, 1.9);
  EXPECT_DOUBLE_EQ(high.submerged_weight, s.submerged_weight - 1030. * 9.81 * 15. * 1.5);
  EXPECT_EQ(high.weight, s.weight);
  const Section back = at_water_level(high, Water(), -1.5);
  EXPECT_NEAR(back.submerged_weight, s.submerged_weight, 1e-9 * s.weight);
}

TEST(Section, DisplacesNoMoreThanItself) {
  const Section s = goda_section();
  EXPECT_DOUBLE_EQ(at_water_level(s, Water(), 10.).submerged_weight, at_water_level(s, Water(), 3.4).submerged_weight);
  EXPECT_DOUBLE_EQ(at_water_level(s, Water(), -9.).submerged_weight, s.submerged_weight + 1030. * 9.81 * 15. * 7.1);
}

}  // namespace section_test
}  // namespace upbead::test
