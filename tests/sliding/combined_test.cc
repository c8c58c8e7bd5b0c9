// Claim: the combined pulse of Shimosako and Takahashi (1998) keeps the impulse of half a standing wave, is the larger
// of its two parts, and slides as far as the triangle alone where there is no standing wave.

#include "upbead/sliding/combined.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <stdexcept>

namespace upbead {
namespace combined_test {

constexpr double pi = boost::math::constants::pi<double>();
const CombinedWave wave{12., 1.2e6, {2.5e6, 1.5}, 0.4e6};

double impulse(const History& h) {
  double sum = 0.;
  for (std::size_t i = 1; i < h.time.size(); ++i)
    sum += 0.5 * (h.value[i] + h.value[i - 1]) * (h.time[i] - h.time[i - 1]);
  return sum;
}

TEST(CombinedSliding, KeepsTheImpulseOfHalfAStandingWave) {
  // the last pulse is so slow that the standing wave rises before it
  for (const TriangularPulse& pulse :
       {TriangularPulse{2.5e6, 0.1}, {2.5e6, 0.8}, {2.5e6, 1.5}, {2.5e6, 2.2}, {1.35e6, 5.}}) {
    CombinedWave w = wave;
    w.impulsive = pulse;
    EXPECT_NEAR(impulse(combined_force(w)), w.standing_force * w.period / pi, 3e-5 * w.standing_force * w.period)
        << pulse.duration;
    EXPECT_GT(standing_reduction(w), 0.);
    EXPECT_LE(standing_reduction(w), 1.);
  }
}

TEST(CombinedSliding, HasNoStandingPartWhereTheImpulseAloneIsMore) {
  CombinedWave w = wave;
  w.impulsive = {5e6, 5.};
  EXPECT_EQ(standing_reduction(w), 0.);
  EXPECT_NEAR(impulse(combined_force(w)), 0.5 * 5e6 * 5., 1.);
}

TEST(CombinedSliding, IsTheLargerOfBothParts) {
  const double gamma = standing_reduction(wave);
  const History F = combined_force(wave);
  for (std::size_t i = 0; i < F.time.size(); ++i) {
    const double t = F.time[i];
    const double P1 = t < 6. ? gamma * 1.2e6 * std::sin(2. * pi * t / 12.) : 0.;
    const double P2 = t < 1.5 ? 2.5e6 * (1. - std::abs(t / 0.75 - 1.)) : 0.;
    EXPECT_NEAR(F.value[i], std::max(P1, P2), 1e-6 * 2.5e6) << t;
  }
}

TEST(CombinedSliding, OfATriangleAloneIsTheExactPulse) {
  CombinedWave w = wave;
  w.standing_force = 0.;
  const double mass = 6e5, mu = 0.6, resistance = 2.0e6;
  const double S = sliding_distance_combined(mass, resistance, mu, w);
  EXPECT_NEAR(S, sliding_distance_exact(mass, resistance, {2.5e6 + mu * 0.4e6, 1.5}), 1e-9 * S);
  EXPECT_GT(S, 0.);
}

/// Small steps of the same equation, with the sine itself.
double by_small_steps(double mass, double resistance, double mu, const CombinedWave& w, bool sinusoidal, double gain) {
  const double gamma = standing_reduction(w), step = 2e-5;
  double x = 0., v = 0.;
  for (double t = 0.5 * step; t < 20.; t += step) {
    const double sine = t < 0.5 * w.period ? std::sin(2. * pi * t / w.period) : 0.;
    const double half = 0.5 * w.impulsive.duration;
    const double P2 = t < 2. * half ? w.impulsive.peak * (1. - std::abs(t - half) / half) : 0.;
    const double P = std::max(gamma * w.standing_force * sine, P2);
    const double U = sinusoidal ? gain * w.uplift * sine : w.uplift * P / w.impulsive.peak;
    v = std::max(0., v + step * (P + mu * U - resistance) / mass);
    x += step * v;
  }
  return x;
}

TEST(CombinedSliding, AgreesWithManySmallSteps) {
  CombinedWave strong = wave;
  strong.standing_force = 2.2e6;  // the standing part alone slides the caisson too
  for (const bool sinusoidal : {false, true}) {
    CombinedModel model;
    model.uplift = sinusoidal ? UpliftShape::sinusoidal : UpliftShape::in_phase;
    model.uplift_gain = 1.3;
    const double mass = 8e5 + added_mass(1030., 10., model), resistance = 1.9e6;
    const double expected = by_small_steps(mass, resistance, 0.6, strong, sinusoidal, 1.3);
    EXPECT_NEAR(sliding_distance_combined(mass, resistance, 0.6, strong, model), expected, 1e-3 * expected);
    EXPECT_GT(expected, 0.01);
  }
}

TEST(CombinedSliding, RestsBelowTheResistance) {
  EXPECT_EQ(sliding_distance_combined(6e5, 2.5e6 + 0.6 * 0.4e6, 0.6, wave), 0.);
}

TEST(CombinedSliding, AddsTheWaterOnBothSides) {
  EXPECT_DOUBLE_EQ(added_mass(1000., 10.), 1.0855e5);
}

TEST(CombinedSliding, UpliftsInPhaseWithTheForceOrAsASine) {
  const History F = combined_force(wave), in_phase = combined_uplift(wave, {});
  CombinedModel model;
  model.uplift = UpliftShape::sinusoidal;
  model.uplift_gain = 1.3;
  const History sine = combined_uplift(wave, model);
  for (std::size_t i = 0; i < F.time.size(); ++i) {
    EXPECT_NEAR(in_phase.value[i], 0.4e6 * F.value[i] / 2.5e6, 1e-9 * 0.4e6) << F.time[i];
    EXPECT_NEAR(sine.value[i], 1.3 * 0.4e6 * std::sin(2. * pi * F.time[i] / 12.), 1e-9 * 0.4e6) << F.time[i];
  }
}

/// Where the pulse is lower than the standing wave, U still is at most U_max, and goes with P.
TEST(CombinedSliding, UpliftsNoMoreThanItsLargestWhereTheStandingPartIsTheLarger) {
  for (const double pulse : {0., 1., 0.3e6, 1.1e6}) {
    CombinedWave w = wave;
    w.impulsive.peak = pulse;
    const History F = combined_force(w), U = combined_uplift(w, {});
    double largest_force = 0., largest_uplift = 0.;
    for (std::size_t i = 0; i < F.time.size(); ++i) {
      largest_force = std::max(largest_force, F.value[i]);
      largest_uplift = std::max(largest_uplift, U.value[i]);
    }
    EXPECT_NEAR(largest_uplift, w.uplift, 1e-9 * w.uplift) << pulse;
    for (std::size_t i = 0; i < F.time.size(); ++i)
      EXPECT_NEAR(U.value[i], w.uplift * F.value[i] / largest_force, 1e-4 * w.uplift) << F.time[i];
    EXPECT_EQ(sliding_distance_combined(6e5, 1.2e6 + 0.6 * 0.4e6, 0.6, w), 0.) << pulse;
    EXPECT_GT(sliding_distance_combined(6e5, 1.2e6, 0.6, w), 0.) << pulse;
  }
}

TEST(CombinedSliding, WithoutAnyForceDoesNotMoveTheCaisson) {
  CombinedWave w = wave;
  w.standing_force = w.impulsive.peak = 0.;
  EXPECT_EQ(sliding_distance_combined(6e5, 1e5, 0.6, w), 0.);
}

TEST(CombinedSliding, RefusesWhatIsNoWave) {
  const auto refuses = [](auto change) {
    CombinedWave w = wave;
    change(w);
    EXPECT_THROW(combined_force(w), std::invalid_argument);
  };
  for (const double bad : {0., -1., std::nan("")}) {
    refuses([&](CombinedWave& w) { w.period = bad; });
    if (bad != 0.) refuses([&](CombinedWave& w) { w.impulsive.peak = bad; });
    refuses([&](CombinedWave& w) { w.impulsive.duration = bad; });
  }
  refuses([](CombinedWave& w) { w.standing_force = -1.; });
  refuses([](CombinedWave& w) { w.uplift = -1.; });
}

TEST(CombinedSliding, RefusesAPulseLongerThanHalfTheWave) {
  CombinedWave w = wave;
  w.impulsive.duration = 6.1;
  EXPECT_THROW(combined_force(w), std::invalid_argument);
}

}  // namespace combined_test
}  // namespace upbead
