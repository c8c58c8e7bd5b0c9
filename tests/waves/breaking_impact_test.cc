// Claim: an impact by PROVERBS is the stated quantile of generalised extreme values times rho g H_b^2; H_b falls with
// the berm and with a wall that reflects more; the share of waves that break there is that between two heights of
// Rayleigh's distribution; the numbers are the stated defaults.
#include "upbead/waves/breaking_impact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sections.h"

namespace upbead::test {
namespace breaking_impact_test {

const Water water;
constexpr double L = 100.;

TEST(BreakingImpact, HasTheQuantileOfItsExtremeValues) {
  const ImpactScatter s;
  // F = exp(-(1 - shape (x - location)/scale)^(1/shape)), inverted
  for (const double q : {0.1, 0.5, 0.9, 0.99}) {
    const double x = relative_impact(s, q);
    EXPECT_NEAR(std::exp(-std::pow(1. - s.shape * (x - s.location) / s.scale, 1. / s.shape)), q, 1e-12);
  }
  EXPECT_NEAR(relative_impact(s, std::exp(-1.)), s.location, 1e-12);
  EXPECT_NEAR(relative_impact(s, 0.9), 8.912, 1e-3);
}

TEST(BreakingImpact, BreaksFromTheStatedHeightOn) {
  ImpactScatter s;
  Section c = goda_section();
  c.berm_width = 0.;
  s.mound_slope = 0.;
  const double tanh_kh = std::tanh(2. * std::acos(-1.) * c.water_depth / L);
  EXPECT_NEAR(breaker_on_wall(s, c, L), (0.1025 + 0.0217 * 0.1 / 1.9) * L * tanh_kh, 1e-12);
  EXPECT_NEAR(breaker_before_wall(c, L), 0.1242 * L * tanh_kh, 1e-12);
  s.reflection = 0.;
  EXPECT_NEAR(breaker_on_wall(s, c, L), breaker_before_wall(c, L), 1e-12) << "0.1025 + 0.0217 = 0.1242";
  double before = breaker_on_wall(s, c, L);
  for (const double berm : {5., 10., 20., 40., 80.}) {
    c.berm_width = berm;
    EXPECT_LE(breaker_on_wall(s, c, L), before);
    before = breaker_on_wall(s, c, L);
  }
  s.breaker = 4.;
  EXPECT_EQ(breaker_on_wall(s, c, L), 4.);
}

TEST(BreakingImpact, HasItsForceShareAndSecondMeasure) {
  const ImpactScatter s;
  const Section c = goda_section();
  const DesignWave wave = goda_wave();
  const BreakingImpact a = breaking_impact(s, c, water, wave, L);
  const double Hb = breaker_on_wall(s, c, L), Hs = wave.significant_height;
  EXPECT_DOUBLE_EQ(a.peak, relative_impact(s, 0.9) * 1030. * 9.81 * Hb * Hb);
  EXPECT_LT(a.median_peak, a.peak);
  EXPECT_NEAR(a.share,
              std::exp(-2. * std::pow(Hb / Hs, 2)) - std::exp(-2. * std::pow(breaker_before_wall(c, L) / Hs, 2)),
              1e-15);
  EXPECT_EQ(a.breaks, wave.height >= Hb);
  EXPECT_NEAR(*a.sr443, 15. * 1030. * 9.81 * 10.1 * 10.1 * std::pow(Hs / 10.1, 3.134), 1.);
  DesignWave low = wave;
  low.significant_height = 2.;
  EXPECT_FALSE(breaking_impact(s, c, water, low, L).sr443) << "H_1/3/h below 0.35";
}

TEST(BreakingImpact, IsToldWithItsSourceItsAssumptionsAndTheMap) {
  BreakingImpact a;
  const auto told = [&a](double mound, double height, double berm) {
    a.relative_mound = mound;
    a.relative_height = height;
    a.relative_berm = berm;
    return text_of({}, a);
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(
      has(told(0.2, 0.3, 0.1), "waves of this sea are quasi-standing by the parameter map, its limits assumed"));
  EXPECT_TRUE(has(told(0.2, 0.4, 0.1), "slightly breaking"));
  EXPECT_TRUE(has(told(0.5, 0.4, 0.2), "slightly breaking"));
  EXPECT_TRUE(has(told(0.7, 0.4, 0.1), "slightly breaking"));
  EXPECT_TRUE(has(told(0.7, 0.4, 0.2), "are impacts by"));
  EXPECT_TRUE(has(told(0.7, 0.4, 0.5), "broken before the wall"));
  EXPECT_TRUE(has(told(0.7, 0.4, 0.2), "no impact: H is below H_b")) << "whatever the map says";
  a.breaks = true;
  EXPECT_TRUE(has(told(0.7, 0.4, 0.2), "PROVERBS (Oumeraci et al. 2001), its numbers assumed"));
}

TEST(BreakingImpact, ScattersItsRiseAboutTheMean) {
  ImpactScatter s;
  EXPECT_EQ(relative_rise(s), 1.);
  double mean = 0.;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    s.rise_quantile = (i + 0.5) / n;
    mean += relative_rise(s) / n;
  }
  EXPECT_NEAR(mean, 1., 2e-3) << "lognormal of mean 1";
}

}  // namespace breaking_impact_test
}  // namespace upbead::test
