// Claim: the bound of the trough exceeds that of the standing wave of finite height, in force and in moment, wherever
// that wave exists, where linear waves do not; its numbers are the integrals of its pressures; and every wave has a
// trough, oblique ones, behind blocks, and ones that break.
#include <gtest/gtest.h>

#include <cmath>

#include "sections.h"
#include "upbead/waves/standing_stability.h"
#include "upbead/waves/wave_heights.h"

namespace upbead::test {
namespace trough_bound_test {

const Water water;
const double rho_g = water.density * water.gravity;

Section section_of(double depth, double foot) {
  Section s = goda_section();
  s.water_depth = depth;
  s.foundation_depth = foot * depth;
  s.berm_depth = 0.9 * s.foundation_depth;
  s.crest = 2. * depth;
  return s;
}

/// Force of a linear standing wave's trough, above the water of which nothing pulls more than rho g z.
double linear(const Section& s, const DesignWave& wave) {
  const double kh = relative_wave_number(wave.period, s.water_depth, water.gravity), h = s.water_depth;
  double force = 0.;
  constexpr int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double z = (i + 0.5) * s.foundation_depth / n;
    force += std::min(z, wave.height * std::cosh(kh * (1. - z / h)) / std::cosh(kh)) * s.foundation_depth / n;
  }
  return rho_g * force;
}

TEST(TroughBound, IsAboveTheTroughOfTheFullEquationsAndLinearWavesAreNot) {
  int waves = 0;
  double least = 10., least_linear = 10.;
  for (const double period : {6., 9., 13.})
    for (const double depth : {8., 15., 30., 60.})
      for (const double relative : {0.05, 0.2, 0.4})
        for (const double foot : {0.6, 1.}) {
          const Section s = section_of(depth, foot);
          const DesignWave wave{relative * depth, relative * depth / 1.8, period, 0.};
          const StandingResult standing = standing_answer(s, water, wave);
          if (!standing.answer) continue;
          const WallPressure& exact = standing.answer->worst.seaward;
          const TroughBound bound = trough_bound(s, water, wave);
          ++waves;
          least = std::min({least, bound.force / -exact.force, bound.force_moment / -exact.force_moment});
          least_linear = std::min(least_linear, linear(s, wave) / -exact.force);
          EXPECT_LT(bound.force / -exact.force, 2.2);
        }
  EXPECT_GT(waves, 25);
  EXPECT_GT(least, 1.05);
  EXPECT_LT(least_linear, 0.7) << "in deep water linear waves pull too little";
}

TEST(TroughBound, IsTheIntegralOfSainflousPressuresWithoutTheRise) {
  for (const double height : {2., 9., 14.}) {
    const Section s = section_of(12., 0.8);
    const DesignWave wave{height, height / 1.8, 10., 0.};
    const TroughBound bound = trough_bound(s, water, wave, 1.5);
    const double bed = height / std::cosh(relative_wave_number(10., 12., water.gravity));
    double force = 0., moment = 0.;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double z = (i + 0.5) * s.foundation_depth / n;
      const double p = z < height ? z : height + (bed - height) * (z - height) / (12. - height);
      force += rho_g * p * s.foundation_depth / n;
      moment += rho_g * p * (s.foundation_depth - z) * s.foundation_depth / n;
    }
    EXPECT_NEAR(bound.force / force, 1.5, 1e-6);
    EXPECT_NEAR(bound.force_moment / moment, 1.5, 1e-6);
    EXPECT_NEAR(bound.seaward.safety_sliding, s.friction * s.submerged_weight / bound.force, 1e-12);
  }
}

TEST(TroughBound, StandsWhereNoStandingWaveDoes) {
  Section s = goda_section();
  const auto has_bound = [](const StandingResult& r) { return !r.answer && !r.why_not.empty() && r.bound; };
  EXPECT_TRUE(has_bound(standing_answer(s, water, goda_wave()))) << "oblique";
  DesignWave breaking = goda_wave();
  breaking.angle = 0.;
  EXPECT_TRUE(has_bound(standing_answer(s, water, breaking))) << "it breaks";
  s.dissipating_blocks = true;
  EXPECT_TRUE(has_bound(standing_answer(s, water, {2., 1.1, 9., 0.})));
  s.dissipating_blocks = false;
  EXPECT_FALSE(standing_answer(s, water, {2., 1.1, 9., 0.}).bound);
}

}  // namespace trough_bound_test
}  // namespace upbead::test
