// Claim: each warning appears where the formulas are outside the range of their data, and only there.

#include "upbead/waves/goda.h"

#include <gtest/gtest.h>

#include "sections.h"
#include "upbead/waves/wave_heights.h"
#include "waves/section_warnings.h"

namespace upbead::test {
namespace validity_test {

std::vector<std::string> names(const Section& section, const DesignWave& wave) {
  const WavePressure pressure = Goda(section, Water(), wave).at(wave.height);
  std::vector<std::string> list;
  for (const NumberedWarning& warning : warnings(section, Water(), wave, pressure)) {
    EXPECT_FALSE(warning.what.empty());
    EXPECT_FALSE(warning.cure.empty()) << warning.name;
    list.push_back(warning.name);
  }
  return list;
}

using Names = std::vector<std::string>;

/// A low mound, on which nothing breaks.
Section ordinary() {
  Section s = sliding_section();
  s.berm_depth = 9.5;
  return s;
}
/// Sets W to match W'.
void weigh(Section& s) {
  s.weight = s.submerged_weight + 1030. * 9.81 * s.foundation_depth * s.width;
}

const DesignWave calm{8., 8. / 1.8, 12., 0.};

TEST(Warnings, AreNoneForAnOrdinaryDesign) {
  EXPECT_EQ(names(ordinary(), calm), Names{});
}

TEST(Warnings, TellOfBreakingOnAHighMound) {
  Section s = ordinary();
  s.berm_depth = 0.59 * s.water_depth;
  EXPECT_EQ(names(s, calm), Names{"impulsive_breaking"});
  s.berm_width = 0.31 * wavelength(12., 15., 9.81);
  EXPECT_EQ(names(s, calm), Names{}) << "waves break before a wide berm";
  s = ordinary();
  s.berm_depth = 0.59 * s.water_depth;
  s.crest = 0.29 * calm.significant_height;
  EXPECT_EQ(names(s, calm), Names{}) << "waves go over a low crest";
  DesignWave oblique = calm;
  oblique.angle = 21. * degree;
  s.crest = 6.;
  EXPECT_EQ(names(s, oblique), Names{}) << "oblique waves do not slam";
}

TEST(Warnings, TellOfBreakingOnASteepBed) {
  Section s = ordinary();
  s.bed_slope = 0.03;
  EXPECT_EQ(names(s, calm), Names{}) << "the mound keeps them off";
  s.berm_width = 0.;
  EXPECT_EQ(names(s, calm), Names{"impulsive_breaking"});
  EXPECT_EQ(names(s, {8., 0.0301 * deep_water_wavelength(12., 9.81), 12., 0.}), Names{}) << "steep waves break earlier";
}

TEST(Warnings, TellOfHighWaves) {
  EXPECT_EQ(names(ordinary(), sliding_wave(11.9)), (Names{"breaking_limit", "overturns"}));
  EXPECT_EQ(names(ordinary(), sliding_wave(12.1)), (Names{"height_over_depth", "breaking_limit", "overturns"}));
}

TEST(Warnings, TellOfGeometryBeyondTheTests) {
  for (const double slope : {0.005, 0.12}) {
    Section s = ordinary();
    s.bed_slope = slope;
    EXPECT_EQ(names(s, calm), Names{"bed_slope"});
  }
  Section s = ordinary();
  s.foundation_depth = 16.;
  s.width = 20.;
  weigh(s);
  EXPECT_EQ(names(s, calm), Names{"foundation_below_bed"});
  s = ordinary();
  s.berm_depth = 15.5;
  EXPECT_EQ(names(s, calm), (Names{"berm_below_bed", "alpha_2_clamped", "alpha_I_negative"}));
}

TEST(Warnings, TellOfCaissonsFarBelowTheBed) {
  Section s = ordinary();
  s.foundation_depth = 80.;
  s.width = 2000.;
  s.submerged_weight = 1e10;
  weigh(s);
  EXPECT_EQ(names(s, calm), (Names{"foundation_below_bed", "alpha_3_clamped"}));
}

TEST(Warnings, TellWhereThePressureEnds) {
  Section s = ordinary();
  s.crest = 12.5;
  EXPECT_EQ(names(s, calm), Names{"eta_star_below_crest"});
  s = ordinary();
  s.submerged_weight = 3e5;
  weigh(s);
  EXPECT_EQ(names(s, calm), Names{"lifted"});
}

TEST(Warnings, TellOfWeightsThatDoNotFitTheWidth) {
  Section s = ordinary();
  s.weight += 0.19 * (s.weight - s.submerged_weight);
  EXPECT_EQ(names(s, calm), Names{});
  s.weight *= 1.2;
  EXPECT_EQ(names(s, calm), Names{"buoyancy"});
}

/// A run warns of a W' that is 2 % too large, and voids its verdict above 10 %.
TEST(Warnings, TellOfAWeightInWaterThatIsTooLarge) {
  Section s = ordinary();
  const double in_water = s.weight - 1030. * 9.81 * s.foundation_depth * s.width;
  const auto found = [&s, in_water](double excess) {
    s.submerged_weight = (1. + excess) * in_water;
    std::string of;
    for (const NumberedWarning& w : section_warnings(s, {1030., 9.81}))
      if (w.name == "buoyancy") of += w.voids ? "void" : "told";
    return of;
  };
  EXPECT_EQ(found(0.01), "");
  EXPECT_EQ(found(0.05), "told");
  EXPECT_EQ(found(0.12), "void");
}

TEST(Warnings, TellOfOddWaves) {
  DesignWave wave = calm;
  wave.significant_height = wave.height;
  EXPECT_EQ(names(ordinary(), wave), Names{"significant_height"});
  wave = calm;
  wave.period = 31.;
  EXPECT_EQ(names(ordinary(), wave), Names{"long_period"});
}

}  // namespace validity_test
}  // namespace upbead::test
