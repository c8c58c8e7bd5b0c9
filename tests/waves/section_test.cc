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

/// The weight keeps its line, and the water's buoyancy acts at B/2: W' t = W t_W - rho g B h' B/2 at every level.
TEST(Section, BuoyancyOfARiseActsAtTheMiddle) {
  Section s = goda_section();
  const double rho_g = 1030. * 9.81, B = s.width, t_W = 6.2;
  const auto line = [&](double depth) {
    const double buoyancy = rho_g * B * depth;
    return (s.weight * t_W - buoyancy * 0.5 * B) / (s.weight - buoyancy);
  };
  s.submerged_weight = s.weight - rho_g * B * s.foundation_depth;
  s.centroid = line(s.foundation_depth);
  for (const double rise : {3., -2., 0.})
    EXPECT_NEAR(*at_water_level(s, Water(), rise).centroid, line(s.foundation_depth + rise), 1e-9) << rise;
  s.centroid.reset();
  EXPECT_FALSE(at_water_level(s, Water(), 3.).centroid) << "at B/2, at every level";
  s.centroid = 0.5 * B;
  EXPECT_NEAR(*at_water_level(s, Water(), 3.).centroid, 0.5 * B, 1e-12);
}

TEST(Section, DisplacesNoMoreThanItself) {
  const Section s = goda_section();
  EXPECT_DOUBLE_EQ(at_water_level(s, Water(), 10.).submerged_weight, at_water_level(s, Water(), 3.4).submerged_weight);
  EXPECT_DOUBLE_EQ(at_water_level(s, Water(), -9.).submerged_weight, s.submerged_weight + 1030. * 9.81 * 15. * 7.1);
}

}  // namespace section_test
}  // namespace upbead::test
