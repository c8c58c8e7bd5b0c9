// Claim: the bound of the trough exceeds that of the standing wave of finite height, in force and in moment, wherever
// that wave exists, where linear waves do not; its numbers are the integrals of its pressures; and every wave has a
// trough, oblique ones, behind blocks, and ones that break.
#include <gtest/gtest.h>

#include <cmath>

#include "sections.h"
#include "upbead/waves/edge_pressures.h"
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

/// By the forces on the base: N = W' + p B/2, and about the middle M_P with p B/2 at B/6 towards the toe.
TEST(Trough, SuctionUnderTheBasePressesTheToe) {
  Section s = goda_section();
  s.centroid = 7.1;
  const double B = s.width;
  const auto toe = [&](double force_moment, double p) {
    const double N = s.submerged_weight + 0.5 * p * B;
    const double M = force_moment + 0.5 * p * B * B / 6. + s.submerged_weight * (7.1 - 0.5 * B);
    return edge_pressures(N, -M, B).seaward.value();  // overturning landward is positive
  };
  const DesignWave stands{3., 1.67, 9., 0.}, breaks{9., 5., 11.4, 0.};
  const StandingResult standing = standing_answer(s, water, stands, 1.2);
  ASSERT_TRUE(standing.answer);
  const WallPressure& trough = standing.answer->worst.seaward;
  ASSERT_LT(trough.edge_pressure, 0.);
  EXPECT_NEAR(*standing.answer->seaward.heel_pressure, toe(-1.2 * trough.force_moment, -1.2 * trough.edge_pressure),
              1e-6);
  EXPECT_GT(*standing.answer->seaward.heel_pressure, toe(-1.2 * trough.force_moment, 0.));
  EXPECT_NEAR(standing.answer->seaward.safety_sliding, s.friction * s.submerged_weight / (-1.2 * trough.force), 1e-9)
      << "no suction helps against sliding";
  // H > h': the water at the wall is gone down to the bottom
  const TroughBound bound = trough_bound(s, water, breaks);
  EXPECT_NEAR(*bound.seaward.heel_pressure, toe(bound.force_moment, rho_g * s.foundation_depth), 1e-6);
}

/// base.toml of a stranger, who recomputed 358.8 kPa; without suction it was 288.1.
TEST(Trough, ToePressureOfASectionWorkedOutByHand) {
  EXPECT_NEAR(*trough_bound(stranger_section(), water, {8., 8. / 1.8, 12., 0.}).seaward.heel_pressure, 358.8e3, 50.);
}

/// Where the resultant is outside the middle third, suction near the toe may take it back: what presses more counts.
TEST(Trough, ToePressureIsNoLessThanWithoutSuction) {
  for (double t = 3.; t < 12.; t += 0.5) {
    Section s = goda_section();
    s.centroid = t;
    const TroughBound bound = trough_bound(s, water, {9., 5., 11.4, 0.});
    const double M = bound.force_moment + s.submerged_weight * (t - 0.5 * s.width);
    const double without = above_all(edge_pressures(s.submerged_weight, -M, s.width).seaward);
    EXPECT_GE(above_all(bound.seaward.heel_pressure), without * (1. - 1e-12)) << t;
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
