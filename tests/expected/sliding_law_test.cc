// Claim: laws are the formulas of a single wave, no wave below the threshold causes sliding, and each factor
// multiplies its own quantity.
#include "upbead/expected/sliding_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "caissons.h"
#include "upbead/sliding/combined.h"
#include "upbead/sliding/pulse.h"

namespace upbead::test {

namespace sliding_law_test {

double distance(Law law, double height, const WaveFactors& factors = {}) {
  return formula_law(law, medium_caisson(), storm(12. / 1.8))->distance(height, factors);
}

TEST(FormulaLaw, IsTheFormulaOfASingleWave) {
  EXPECT_NEAR(distance(Law::paper, 12.), 0.07562, 5e-6);
  EXPECT_NEAR(distance(Law::exact, 12.), 0.12542, 5e-6);
  EXPECT_EQ(distance(Law::exact, 9.), 0.);
}

TEST(FormulaLaw, CombinedTakesTheStandingWaveAndTheAddedMass) {
  const Breakwater c = medium_caisson();
  const SeaState sea = storm(12. / 1.8);
  const Goda goda(c.section, c.water, {0., sea.significant_height, sea.period, 0.});
  const WavePressure with = goda.at(12.), without = goda.at(12., PressureFormula::standing);
  const SlidingLoad load = sliding_load(c.section, c.water, with, 12., sea.period);
  const double mass = c.section.weight / 9.81 + 1.0855 * 1030. * 10.5 * 10.5;
  const double S = sliding_distance_combined(mass, load.resistance, 0.6,
                                             {12., without.force, {with.force, load.pulse.duration}, with.uplift});
  EXPECT_GT(S, 0.);
  EXPECT_NEAR(distance(Law::combined, 12.), S, 1e-9 * S);
}

TEST(FormulaLaw, CombinedKnowsItsModel) {
  Breakwater breakwater = medium_caisson();
  const double in_phase = formula_law(Law::combined, breakwater, storm(6.))->distance(12.);
  breakwater.combined.added_mass_factor = 0.;
  EXPECT_GT(formula_law(Law::combined, breakwater, storm(6.))->distance(12.), in_phase);
  breakwater.combined.uplift = UpliftShape::sinusoidal;
  breakwater.combined.uplift_gain = 4.;
  const auto lifted = formula_law(Law::combined, breakwater, storm(6.));
  double first = 1.;
  while (lifted->distance(first) == 0.) first += 0.01;
  EXPECT_LE(lifted->threshold(), first) << "a larger uplift lets lower waves slide";
  EXPECT_LT(first, formula_law(Law::exact, breakwater, storm(6.))->threshold());
}

TEST(FormulaLaw, NothingSlidesBelowTheThresholdAndEverythingAbove) {
  for (const double friction : {0.5, 0.6, 0.7})
    for (const Law law : {Law::paper, Law::exact, Law::combined}) {
      WaveFactors factors;
      factors.friction = friction / 0.6;
      const auto of = formula_law(law, medium_caisson(), storm(6.));
      const double H = of->threshold(factors);
      EXPECT_GT(H, 5.);
      EXPECT_EQ(of->distance(H * (1. - 1e-9), factors), 0.);
      EXPECT_FALSE(of->may_slide(H * (1. - 1e-9), factors));
      EXPECT_TRUE(of->may_slide(H * (1. + 1e-9), factors));
      EXPECT_GT(of->distance(H * (1. + 1e-4), factors), 0.);
    }
}

TEST(FormulaLaw, AWallOfMountainsNeverSlides) {
  Breakwater caisson = medium_caisson();
  caisson.section.weight *= 1e6;
  caisson.section.submerged_weight *= 1e6;
  EXPECT_EQ(formula_law(Law::exact, caisson, storm(6.))->threshold(), HUGE_VAL);
}

TEST(FormulaLaw, FactorsScaleForceUpliftFrictionAndWeight) {
  const WavePressure p = WaveForces(medium_caisson(), storm(6.)).at(12., {});
  WaveFactors factors;
  factors.force = 1.1;
  factors.uplift = 0.8;
  const WavePressure q = WaveForces(medium_caisson(), storm(6.)).at(12., factors);
  EXPECT_DOUBLE_EQ(q.force, 1.1 * p.force);
  EXPECT_DOUBLE_EQ(q.uplift, 0.8 * p.uplift);
  factors.friction = 1.2;
  factors.weight = 1.05;
  const Section s = medium_caisson().section, f = with_factors(s, factors);
  EXPECT_DOUBLE_EQ(f.friction, 1.2 * s.friction);
  EXPECT_DOUBLE_EQ(f.weight, 1.05 * s.weight);
  EXPECT_NEAR(f.weight - f.submerged_weight, s.weight - s.submerged_weight, 1e-6) << "buoyancy stays";
}

/// W' t = W t_W - (W - W') B/2: the line t_W of the weight and the buoyancy stay when the weight grows.
TEST(FormulaLaw, MoreWeightActsInTheLineOfTheWeight) {
  Section s = medium_caisson().section;
  const double buoyancy = s.weight - s.submerged_weight, t_W = 0.42 * s.width;
  const auto line = [&](double weight) { return (weight * t_W - buoyancy * 0.5 * s.width) / (weight - buoyancy); };
  s.centroid = line(s.weight);
  WaveFactors factors;
  for (const double weight : {1.1, 0.9, 1.}) {
    factors.weight = weight;
    EXPECT_NEAR(*with_factors(s, factors).centroid, line(weight * s.weight), 1e-9) << weight;
  }
  s.centroid.reset();
  EXPECT_FALSE(with_factors(s, factors).centroid);
}

TEST(FormulaLaw, TheWaterLevelChangesDepthsAndBuoyancy) {
  SeaState high = storm(6.);
  high.water_level = 1.;
  const Breakwater raised = WaveForces(medium_caisson(), high).breakwater();
  EXPECT_EQ(raised.section.water_depth, 16.);
  EXPECT_EQ(raised.section.crest, 5.);
  EXPECT_LT(raised.section.submerged_weight, medium_caisson().section.submerged_weight);
}

}  // namespace sliding_law_test
}  // namespace upbead::test
