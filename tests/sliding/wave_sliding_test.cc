// Claim: the chain from the height of a wave to its sliding distance, row by row of a table that was computed once by
// another program (declared section, not published); both parts of eq. (7); impulsive waves slide the caisson less
// far than other waves of the same safety factor, as Fig. 10 of Shimosako and Takahashi (1994) shows.

#include "upbead/sliding/pulse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../waves/sections.h"
#include "upbead/waves/wave_heights.h"

namespace upbead::test {
namespace wave_sliding_test {

const Water water;

SlidingLoad load_of(const Section& section, const DesignWave& wave) {
  return sliding_load(section, water, Goda(section, water, wave).at(wave.height), wave.height, wave.period);
}

double by_equation_7(const SlidingLoad& load) {
  return sliding_distance_paper(load.mass, load.resistance, load.pulse);
}

PaperParts parts_of(const SlidingLoad& load) {
  return sliding_distance_paper_parts(load.mass, load.resistance, load.pulse);
}

TEST(WaveSliding, HoldsRowByRow) {
  struct Row {
    double H, paper, exact;
  };
  for (const Row& row : {Row{8., 0., 0.}, Row{9., 0., 0.}, Row{10., 0.00011, 0.00021}, Row{11., 0.01520, 0.02709},
                         Row{12., 0.07562, 0.12542}}) {
    const SlidingLoad load = load_of(sliding_section(), sliding_wave(row.H));
    EXPECT_NEAR(by_equation_7(load), row.paper, 5.01e-6) << row.H;
    EXPECT_NEAR(sliding_distance_exact(load.mass, load.resistance, load.pulse), row.exact, 5.01e-6) << row.H;
  }
}

TEST(WaveSliding, TakesTheWeightInAirForTheMassAndUpliftIntoTheForce) {
  const Section s = sliding_section();
  const WavePressure p = Goda(s, water, sliding_wave(11.)).at(11.);
  const SlidingLoad load = load_of(s, sliding_wave(11.));
  EXPECT_DOUBLE_EQ(load.mass, s.weight / 9.81);
  EXPECT_DOUBLE_EQ(load.resistance, 0.6 * s.submerged_weight);
  EXPECT_DOUBLE_EQ(load.pulse.peak, p.force + 0.6 * p.uplift);
}

TEST(WaveSliding, PartsOfEquation7AreItsSumAndItsBraking) {
  for (const double H : {10., 11., 12., 14.}) {
    const SlidingLoad load = load_of(sliding_section(), sliding_wave(H));
    const PaperParts parts = parts_of(load);
    EXPECT_NEAR(parts.accelerating + parts.braking, by_equation_7(load), 1e-14);
    // Braking from V = tau_0 (F - R)^2 / (2 m F) by R alone.
    const double F = load.pulse.peak, R = load.resistance;
    const double V = load.pulse.duration * std::pow(F - R, 2) / (2. * load.mass * F);
    EXPECT_NEAR(parts.braking, V * V * load.mass / (2. * R), 1e-12 * parts.braking);
  }
  EXPECT_EQ(parts_of(load_of(sliding_section(), sliding_wave(8.))).braking, 0.);
}

/// The section, with the weight for which the safety factor against sliding is `safety`.
Section weighed(Section s, const DesignWave& wave, double safety) {
  const double buoyancy = s.weight - s.submerged_weight;
  s.submerged_weight = submerged_weight_for(safety, s.friction, Goda(s, water, wave).at(wave.height));
  s.weight = s.submerged_weight + buoyancy;
  return s;
}

TEST(WaveSliding, ImpulsiveWavesSlideLessFarAtEqualSafetyFactor) {
  Section low = sliding_section(), high = low;
  low.berm_depth = 10.4;
  high.berm_depth = 6.;
  high.berm_width = 0.12 * wavelength(12., 15., 9.81);
  const DesignWave wave = sliding_wave(11.);
  ASSERT_GT(Goda(high, water, wave).at(11.).alpha_star, 5. * Goda(low, water, wave).at(11.).alpha_star);
  for (const double friction : {0.5, 0.6, 0.7})
    for (double safety = 0.6; safety < 0.995; safety += 0.01) {
      low.friction = high.friction = friction;
      const double S_low = by_equation_7(load_of(weighed(low, wave, safety), wave));
      const double S_high = by_equation_7(load_of(weighed(high, wave, safety), wave));
      EXPECT_LT(S_high, S_low) << "mu " << friction << ", S.F. " << safety;
      EXPECT_GT(S_high, 0.);
    }
}

}  // namespace wave_sliding_test
}  // namespace upbead::test
