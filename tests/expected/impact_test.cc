// Claim: the force of a wave is the declared one: its peak, rise, duration and impulse.
#include "expected/dynamic_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace upbead::test {

namespace impact_test {

constexpr double step = 1e-4;

ImpactWave wave(double alpha_star, const ImpactAssumptions& assumptions = {}) {
  return impact_wave(assumptions, {8., 12., 1.2e6, alpha_star, 4e5, 1.2e6 * (1. + 0.5 * alpha_star)}, {}, 8.5);
}

std::vector<double> force(const ImpactWave& w) {
  std::vector<double> P(static_cast<std::size_t>(number_of_samples(w, step)));
  sample_force(w, step, static_cast<int>(P.size()), P.data());
  return P;
}

std::vector<double> uplift(const ImpactWave& w, ImpactUplift shape) {
  const std::vector<double> P = force(w);
  std::vector<double> U(P.size());
  sample_uplift(w, shape, step, static_cast<int>(P.size()), P.data(), U.data());
  return U;
}

double impulse(const std::vector<double>& P) {
  double sum = 0.;
  for (const double p : P) sum += p * step;
  return sum;
}

const double half_wave = 1.2e6 * 12. / std::acos(-1.);

TEST(ImpactWave, PeakRiseAndDurationAreTheDeclaredFormulas) {
  ImpactAssumptions half;
  half.peak_gain = 0.5;
  const ImpactWave w = wave(0.5, half);
  EXPECT_DOUBLE_EQ(w.peak, 1.2e6 * 1.25) << "e = 0.5";
  const double rise = 0.769 * std::sqrt(8.5 / 9.81) * 1030. * 9.81 * 64. / 1.5e6;
  EXPECT_NEAR(w.rise, rise, 1e-12);
  EXPECT_NEAR(w.duration, rise * (2. + 8. * std::exp(-18. * rise / 12.)), 1e-12);
  const std::vector<double> P = force(w);
  EXPECT_NEAR(*std::max_element(P.begin(), P.end()), w.peak, 1e-3 * w.peak);
  EXPECT_EQ(P.front(), 0.);
  EXPECT_NEAR(P.back(), 0., 1e-3 * w.peak);
}

TEST(ImpactWave, HasGodasForceForAPeakWithoutAGain) {
  EXPECT_EQ(impact_wave({}, {8., 12., 1.2e6, 0.5, 4e5, 1.7e6}, {}, 8.5).peak, 1.7e6);
  EXPECT_EQ(impact_wave({}, {8., 12., 1.2e6, 0., 4e5, 1.2e6}, {}, 8.5).peak, 1.2e6);
}

TEST(ImpactWave, ByProverbsBreaksFromHbOnAndIsNeverBelowGoda) {
  ImpactAssumptions proverbs;
  proverbs.proverbs.emplace();
  const auto of = [&](double height, double breaker) {
    return impact_wave(proverbs, {height, 12., 0.8e6, 0.5, 4e5, 1e6, breaker}, {}, 8.5);
  };
  EXPECT_EQ(of(5.9, 6.).peak, 1e6) << "below H_b it does not break";
  const double F = relative_impact(*proverbs.proverbs, 0.9);
  EXPECT_DOUBLE_EQ(of(6., 6.).peak, F * 1030. * 9.81 * 36.);
  EXPECT_DOUBLE_EQ(of(9., 6.).peak, F * 1030. * 9.81 * 36.) << "H_b decides, not H";
  EXPECT_NEAR(of(6., 6.).rise, 0.769 * std::sqrt(8.5 / 9.81) / F, 1e-12);
  EXPECT_EQ(of(6., 1.).peak, 1e6) << "not below Goda's P";
  proverbs.proverbs->rise_quantile = 0.9;
  EXPECT_GT(of(6., 6.).rise, 0.769 * std::sqrt(8.5 / 9.81) / F);
}

TEST(ImpactWave, KeepsTheImpulseOfHalfAStandingWave) {
  for (const double alpha_star : {0., 0.1, 0.3, 0.6, 1.}) {
    const ImpactWave w = wave(alpha_star);
    EXPECT_GT(w.reduction, 0.);
    EXPECT_LE(w.reduction, 1.);
    const double found = impulse(force(w));
    if (w.reduction < 1.) {
      EXPECT_NEAR(found, half_wave, 1e-4 * half_wave) << alpha_star;
    }
    EXPECT_GE(found, half_wave * (1. - 1e-4));
  }
}

TEST(ImpactWave, APulseOfMoreImpulseLeavesNoStandingWave) {
  ImpactAssumptions strong;
  strong.peak_gain = 20.;
  strong.rise_coefficient = 20.;
  const ImpactWave w = wave(1., strong);
  EXPECT_EQ(w.reduction, 0.);
  EXPECT_LE(w.duration, 6.) << "ends with the half period";
  EXPECT_LE(w.rise, 0.5 * w.duration);
}

/// P_I = P_1 at T/4, where the sine has the same value but for round-off.
TEST(ImpactWave, ATriangleThatNeverLeadsLeavesTheStandingWave) {
  for (int i = 1; i <= 1000; ++i) {
    const ImpactWave wave = impact_wave({}, {8., 0.015 * i, 1e5 + 7.3 * i, 0., 1e4}, {}, 8.5);
    EXPECT_EQ(wave.rise, 0.25 * wave.period);
    EXPECT_EQ(wave.reduction, 1.) << i;
    EXPECT_NEAR(force_at(wave, wave.rise), wave.standing_force, 1e-12 * wave.peak) << i;
    EXPECT_NEAR(force_at(wave, 0.5 * wave.rise), wave.standing_force * std::sqrt(0.5), 1e-12 * wave.peak) << i;
  }
}

TEST(ImpactWave, UpliftIsHeldInPhaseOrSinusoidal) {
  const ImpactWave w = wave(0.5);
  const std::vector<double> held = uplift(w, ImpactUplift::held), sine = uplift(w, ImpactUplift::sinusoidal);
  const std::vector<double> in_phase = uplift(w, ImpactUplift::in_phase), P = force(w);
  const auto at = [](double t) { return static_cast<std::size_t>(std::lround(t / step)); };
  EXPECT_EQ(held[at(0.)], 4e5);
  EXPECT_EQ(held[at(2.9)], 4e5);
  EXPECT_NEAR(held[at(4.5)], 4e5 * std::sqrt(0.5), 1.);
  EXPECT_NEAR(sine[at(1.)], 2e5, 1.);
  for (const double t : {0.1, 1., 4.}) EXPECT_NEAR(in_phase[at(t)], 4e5 * P[at(t)] / w.peak, 1e-6);
}

}  // namespace impact_test
}  // namespace upbead::test
