// Claim: the law dynamic is slide() on the response of the reduced model; a stiff caisson transmits its force
// unchanged; waves that are skipped would not have slid.
#include "expected/dynamic_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oscillator.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/sliding/block.h"

namespace upbead::test {

namespace dynamic_law_test {

DynamicLaw law(double frequency, double ratio, double step = 2e-3, const ImpactAssumptions& assumptions = {},
               double longest = 10.) {
  return {medium_caisson(), storm(6.), assumptions,
          std::make_shared<const ShearAnswer>(oscillator(frequency, ratio), step, longest)};
}

double resistance() {
  return 0.6 * medium_caisson().section.submerged_weight;
}

TEST(DynamicLaw, AStiffCaissonPassesTheForceOn) {
  const DynamicLaw stiff = law(200., 0.7);
  const DynamicWave wave = stiff.wave(11.);
  const double peak = *std::max_element(wave.force.begin(), wave.force.end());
  for (std::size_t i = 0; i < wave.force.size(); ++i) ASSERT_NEAR(wave.shear[i], wave.force[i], 0.02 * peak) << i;
  History with_uplift{wave.time, wave.force};
  for (std::size_t i = 0; i < wave.force.size(); ++i)
    with_uplift.value[i] += wave.sliding_force[i] - wave.shear[i];  // mu U
  const double S = slide(medium_caisson().section.weight / 9.81, with_uplift, resistance()).residual;
  EXPECT_GT(S, 0.);
  EXPECT_NEAR(stiff.distance(11., {}), S, 5e-3 * S);
}

TEST(DynamicLaw, IsSlideOnTheAnswerOfTheModel) {
  const DynamicLaw soft = law(1.5, 0.1);
  const DynamicWave wave = soft.wave(11.);
  const Sliding whole = slide(medium_caisson().section.weight / 9.81, {wave.time, wave.sliding_force}, resistance());
  EXPECT_GT(whole.residual, 0.);
  EXPECT_NEAR(soft.distance(11., {}), whole.residual, 1e-12 * whole.residual);
  EXPECT_NEAR(wave.sliding, whole.residual, 1e-12 * whole.residual);
}

TEST(DynamicLaw, WhatIsSkippedWouldNotHaveSlid) {
  const DynamicLaw bounded = law(1.5, 0.1), unbounded = law(1.5, 0.1, 2e-3, {}, 0.1);  // unbounded: all computed
  EXPECT_EQ(unbounded.threshold({}), 0.);
  const double threshold = bounded.threshold({});
  EXPECT_GT(threshold, 2.) << "the bound is good for something";
  for (double H = 0.5; H < 14.; H += 0.25) {
    EXPECT_EQ(bounded.distance(H, {}), unbounded.distance(H, {})) << H;
    EXPECT_EQ(bounded.may_slide(H, {}), H > threshold) << H;
    if (H < threshold) {
      EXPECT_EQ(unbounded.distance(H, {}), 0.) << H;
    }
  }
}

/// Masses on springs from 1 to 50 Hz side by side, each with its share of the force.
ShearModel many_oscillators() {
  ShearModel all = oscillator(1., 0.1);
  constexpr int n = 40;
  Eigen::VectorXcd pole(n), reading(n);
  for (int i = 0; i < n; ++i) {
    const ShearModel one = oscillator(1. + 49. * i / (n - 1.), 0.02 + 0.002 * i);
    pole[i] = one.modes.pole[0];
    reading[i] = one.modes.reading(0, 0) * (i % 3 == 0 ? 2. : -0.5) / 7.;
  }
  all.modes.pole = pole;
  all.modes.load = Eigen::MatrixXcd::Constant(n, 1, 1e6);
  all.modes.reading = reading.transpose();
  return all;
}

TEST(DynamicLaw, WhatFewModesRuleOutWouldNotHaveSlid) {
  const auto answer = std::make_shared<const ShearAnswer>(many_oscillators(), 2e-3, 10.);
  ImpactAssumptions mild;
  mild.peak_gain = 0.5;
  const DynamicLaw law(medium_caisson(), storm(6.), mild, answer);
  int ruled_out = 0;
  double nearest = 0.;
  for (double H = 0.5; H < 16.; H += 0.1) {
    const DynamicWave wave = law.wave(H);
    const double bound = answer->bound(wave.force.data(), static_cast<int>(wave.force.size()));
    double largest = 0.;
    for (const double F : wave.shear) largest = std::max(largest, std::abs(F));
    EXPECT_LE(largest, bound) << H;
    nearest = std::max(nearest, largest / bound);
    EXPECT_EQ(law.distance(H, {}), std::max(wave.sliding, 0.)) << H;
    ruled_out += law.may_slide(H, {}) && bound + 0.6 * wave.wave.uplift < resistance();
  }
  EXPECT_GT(nearest, 0.9);
  EXPECT_GT(ruled_out, 0) << "more than the bound without an answer does";
}

TEST(DynamicLaw, TheBoundHoldsForTheWorstForce) {
  const ShearAnswer answer(oscillator(1.5, 0.02), 0.01, 10.);
  const int n = 900;
  std::vector<double> hat(n, 0.), kernel(n), worst(n, 0.), F(n);
  hat[1] = 1.;
  answer.respond(hat.data(), n, kernel.data());
  for (int k = 1; k < n; ++k)
    worst[static_cast<std::size_t>(k)] = kernel[static_cast<std::size_t>(n - k)] > 0. ? 1. : -1.;
  answer.respond(worst.data(), n, F.data());
  EXPECT_NEAR(F.back(), answer.bound({1., 10., HUGE_VAL, HUGE_VAL}, n - 1), 1e-9 * F.back()) << "reached";
  EXPECT_GT(F.back(), 5.);
}

TEST(DynamicLaw, TheBoundHoldsForEveryWaveAndIsNearItWhereTheCaissonIsStiff) {
  for (const double frequency : {0.3, 1., 2., 4., 20.})
    for (const double ratio : {0.02, 0.1, 0.5}) {
      const auto answer = std::make_shared<const ShearAnswer>(oscillator(frequency, ratio), 2e-3, 10.);
      const DynamicLaw law(medium_caisson(), storm(6.), {}, answer);
      for (const double height : {1., 3., 6., 9., 12.}) {
        const DynamicWave wave = law.wave(height);
        double largest = 0.;
        for (const double F : wave.shear) largest = std::max(largest, std::abs(F));
        const double bound = answer->bound(limits(wave.wave), static_cast<int>(wave.shear.size()));
        EXPECT_LE(largest, bound) << frequency << " Hz, " << ratio << ", " << height << " m";
        if (frequency > 10. && ratio > 0.05) {
          EXPECT_LT(bound, 1.5 * largest);
        }
      }
    }
}

TEST(DynamicLaw, StepsThatHalveChangeLittle) {
  const double coarse = law(1.5, 0.1, 4e-3).distance(11., {}), fine = law(1.5, 0.1, 1e-3).distance(11., {});
  EXPECT_NEAR(coarse, fine, 1e-3 * fine);
}

TEST(DynamicLaw, TheFactorOfTheForceScalesTheHistory) {
  WaveFactors factors;
  factors.force = 1.2;
  const DynamicLaw soft = law(1.5, 0.1);
  const DynamicWave plain = soft.wave(10.), scaled = soft.wave(10., factors);
  ASSERT_EQ(plain.force.size(), scaled.force.size());
  for (std::size_t i = 0; i < plain.force.size(); i += 100)
    EXPECT_NEAR(scaled.shear[i], 1.2 * plain.shear[i], 1e-9 * plain.wave.peak);
}

TEST(DynamicLaw, TheExpectationIsThatOfASumOverHeights) {
  const DynamicLaw soft = law(1.5, 0.1, 4e-3);
  for (const double limit : {RayleighHeights::no_cut, 11.}) {
    const RayleighHeights heights(6., RayleighHeights::no_cut, limit), all(6.);
    const Expectation found = expected_distance(soft, heights, 600., {1e-4, 6});
    double sum = 0.;
    for (double H = 5.0025; H < 25.; H += 0.005)
      sum += 600. * soft.distance(std::min(H, limit), {}) * all.density(H) * 0.005;
    EXPECT_GT(sum, 0.);
    EXPECT_NEAR(found.distance, sum, 1e-3 * sum) << limit;
  }
}

}  // namespace dynamic_law_test
}  // namespace upbead::test
