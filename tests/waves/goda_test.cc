// Claim: the pressures are those of Goda's example, with alpha_2 and with alpha_I, and known pitfalls of these
// formulas are avoided.

#include "upbead/waves/goda.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sections.h"
#include "upbead/waves/wave_heights.h"

namespace upbead::test {
namespace goda_test {

const Water water;

WavePressure example(PressureFormula formula) {
  return Goda(goda_section(), water, goda_wave()).at(goda_wave().height, formula);
}

TEST(Goda, GivesTheExampleOfTheBook) {
  const WavePressure p = example(PressureFormula::goda);
  EXPECT_NEAR(p.alpha_1, 0.92058, 5e-6);
  EXPECT_NEAR(p.alpha_2, 0.31754, 5e-6);
  EXPECT_NEAR(p.alpha_3, 0.89315, 5e-6);
  EXPECT_NEAR(p.eta_star, 11.86928, 2e-5);
  EXPECT_NEAR(p.p1, 97291.7, 0.1);
  EXPECT_NEAR(p.p3, 86896.5, 0.1);
  EXPECT_NEAR(p.p4, 69422.1, 0.1);
  EXPECT_NEAR(p.pu, 65739.3, 0.1);
  EXPECT_NEAR(p.force, 937281., 1.);
  EXPECT_NEAR(p.force_moment, 4832090., 5.);
  EXPECT_NEAR(p.uplift, 493045., 1.);
  EXPECT_NEAR(p.uplift_moment, 4930448., 5.);
}

TEST(Goda, GivesTheExampleWithTheImpulsiveCoefficient) {
  const WavePressure p = example(PressureFormula::extended);
  EXPECT_NEAR(p.alpha_I, 0.32228, 5e-6);
  EXPECT_EQ(p.alpha_star, p.alpha_I);
  EXPECT_NEAR(p.p1, 97644.84, 0.1);
  EXPECT_NEAR(p.p3, 87211.93, 0.1);
  EXPECT_NEAR(p.p4, 69674.10, 0.1);
  EXPECT_NEAR(p.pu, 65739.31, 0.1);
  EXPECT_NEAR(p.force, 940684., 1.);
  EXPECT_NEAR(p.force_moment, 4849630., 5.);
  EXPECT_EQ(p.uplift, example(PressureFormula::goda).uplift) << "U knows neither alpha_2 nor alpha_I";
}

TEST(Goda, GivesTheStronglyImpulsivePoint) {
  Section s = sliding_section();
  s.water_depth = 12.;
  s.berm_depth = 4.8;
  s.foundation_depth = 7.2;
  s.crest = 5.;
  s.width = 18.;
  s.berm_width = 0.12 * wavelength(12., 12., 9.81);
  const WavePressure p = Goda(s, water, {8., 8., 12., 0.}).at(8.);  // h_b = 12 + 5 x 8 x 0.01 = 12.4 m
  EXPECT_NEAR(p.alpha_1, 0.909743, 5e-7);
  EXPECT_NEAR(p.alpha_2, 0.567503, 5e-7);
  EXPECT_NEAR(p.alpha_I, 1.666667, 5e-7);
  EXPECT_NEAR(p.p1, 208262.51, 6e-3);
  EXPECT_NEAR(p.p3, 187943.14, 6e-3);
  EXPECT_NEAR(p.p4, 121486.46, 6e-3);
  EXPECT_NEAR(p.pu, 66363.64, 6e-3);
  EXPECT_NEAR(p.force, 2250712.7, 0.06);
  EXPECT_NEAR(p.force_moment, 13038233.9, 0.06);
  EXPECT_NEAR(p.uplift, 597272.7, 0.06);
}

TEST(Goda, OfAStandingWaveLeavesTheMoundOut) {
  const WavePressure p = example(PressureFormula::standing), q = example(PressureFormula::goda);
  const double c = std::cos(15. * degree);
  EXPECT_NEAR(p.p1 / q.p1, p.alpha_1 / (p.alpha_1 + p.alpha_2 * c * c), 1e-14);
  EXPECT_EQ(p.alpha_star, q.alpha_star) << "k(alpha*) does not depend on the formula of the pressure";
}

TEST(Goda, TakesTheWavelengthAtTheWallAndNotAtHb) {
  Section steep = goda_section();
  steep.bed_slope = 0.05;
  const Goda goda(steep, water, goda_wave());
  EXPECT_DOUBLE_EQ(goda.wavelength(), wavelength(11.4, 10.1, 9.81));
  EXPECT_DOUBLE_EQ(goda.seaward_depth(), 10.1 + 5. * goda_wave().significant_height * 0.05);
}

TEST(Goda, TurnsTheAngleOnce) {
  // At beta = 90 degrees half of the pressure by alpha_1 remains, and none of that by alpha*.
  DesignWave wave = goda_wave();
  wave.angle = 90. * degree;
  const WavePressure p = Goda(goda_section(), water, wave).at(wave.height);
  EXPECT_NEAR(p.p1, 0.5 * p.alpha_1 * 1030. * 9.81 * wave.height, 1e-9 * p.p1);
  EXPECT_NEAR(p.eta_star, 0.75 * wave.height, 1e-12);
}

TEST(Goda, HasNoPressureAtACrestThatItDoesNotReach) {
  Section high = goda_section();
  high.crest = 20.;
  const WavePressure p = Goda(high, water, goda_wave()).at(8.);
  ASSERT_LT(p.eta_star, high.crest);
  EXPECT_EQ(p.p4, 0.);
  EXPECT_NEAR(p.force, 0.5 * (p.p1 + p.p3) * 7.1 + 0.5 * p.p1 * p.eta_star, 1e-9 * p.force);
  EXPECT_NEAR(p.force_moment,
              (2. * p.p1 + p.p3) * 7.1 * 7.1 / 6. + 0.5 * p.p1 * 7.1 * p.eta_star + p.p1 * p.eta_star * p.eta_star / 6.,
              1e-9 * p.force_moment);
}

TEST(Goda, HasNoPressureBesideAlpha1OverALowMound) {
  Section low = sliding_section();
  low.berm_depth = 15.2;  // deeper than h_b = 15.1 m: alpha_2 would be negative
  const WavePressure p = Goda(low, water, {3.6, 2., 12., 0.}).at(3.6);
  EXPECT_EQ(p.alpha_2, 0.);
  EXPECT_LT(p.alpha_I, 0.);
  EXPECT_EQ(p.alpha_star, 0.) << "alpha_I alone would lower the pressure";
  EXPECT_EQ(p.p1, Goda(low, water, {3.6, 2., 12., 0.}).at(3.6, PressureFormula::standing).p1);
}

TEST(Goda, TakesAlpha2WhereAlphaIIsNegative) {
  Section low = sliding_section();
  low.berm_depth = 13.;
  const WavePressure p = Goda(low, water, sliding_wave(8.)).at(8.);
  EXPECT_LT(p.alpha_I, 0.);
  EXPECT_GT(p.alpha_2, 0.);
  EXPECT_EQ(p.alpha_star, p.alpha_2);
}

TEST(Goda, EndsAlpha2WhereWavesBreakOnTheBerm) {
  Section high = goda_section();
  high.berm_depth = 1.;
  const WavePressure p = Goda(high, water, goda_wave()).at(8.);
  EXPECT_DOUBLE_EQ(p.alpha_2, 2. * 1. / 8.);
  EXPECT_LE(p.alpha_star, 2.);
}

TEST(Goda, NeverPullsAtACaissonFarBelowTheBed) {
  Section sunk = sliding_section();
  sunk.foundation_depth = 80.;
  const WavePressure p = Goda(sunk, water, sliding_wave(8.)).at(8.);
  EXPECT_EQ(p.alpha_3, 0.) << "1 - (h'/h)(1 - 1/cosh kh) is negative";
  EXPECT_GT(p.force, 0.);
  EXPECT_EQ(p.uplift, 0.);
}

TEST(Goda, DoesNotOverflowInDeepWater) {
  Section deep = sliding_section();
  deep.water_depth = 1e5;
  const WavePressure p = Goda(deep, water, {0.5, 0.3, 1., 0.}).at(0.5);
  EXPECT_EQ(p.alpha_1, 0.6);
  EXPECT_NEAR(p.alpha_3, 1. - 10.5 / 1e5, 1e-15);
  EXPECT_TRUE(std::isfinite(p.force) && std::isfinite(p.alpha_I));
}

TEST(Goda, KnowsWallsBehindBlocks) {
  Section s = goda_section();
  s.dissipating_blocks = true;
  const Goda blocks(s, water, goda_wave());
  for (const auto& [ratio, lambda] :
       {std::pair(0.2, 1.), {0.3, 1.}, {0.33, 0.98}, {0.45, 0.9}, {0.57, 0.82}, {0.6, 0.8}, {0.9, 0.8}}) {
    const WavePressure p = blocks.at(ratio * 10.1), plain = Goda(goda_section(), water, goda_wave()).at(ratio * 10.1);
    EXPECT_NEAR(p.lambda_1, lambda, 1e-12);
    EXPECT_EQ(p.lambda_2, 0.);
    EXPECT_EQ(p.lambda_3, p.lambda_1);
    EXPECT_NEAR(p.pu, lambda * plain.pu, 1e-12 * plain.pu);
    EXPECT_NEAR(p.eta_star, lambda * plain.eta_star, 1e-12);
    EXPECT_EQ(p.alpha_star, plain.alpha_star);
  }
  s.lambda_1 = 0.5;
  s.lambda_2 = 0.3;
  s.lambda_3 = 0.7;
  const WavePressure own = Goda(s, water, goda_wave()).at(8.);
  EXPECT_EQ((std::array{own.lambda_1, own.lambda_2, own.lambda_3}), (std::array{0.5, 0.3, 0.7}));
}

TEST(Goda, RefusesWhatIsNotPositive) {
  const auto wrong = [](auto change) {
    Section s = goda_section();
    DesignWave w = goda_wave();
    change(s, w);
    EXPECT_THROW(Goda(s, water, w), std::invalid_argument);
  };
  wrong([](Section& s, DesignWave&) { s.water_depth = 0.; });
  wrong([](Section& s, DesignWave&) { s.berm_depth = -1.; });
  wrong([](Section& s, DesignWave&) { s.foundation_depth = std::nan(""); });
  wrong([](Section&, DesignWave& w) { w.period = 0.; });
  wrong([](Section&, DesignWave& w) { w.significant_height = 0.; });
}

}  // namespace goda_test
}  // namespace upbead::test
