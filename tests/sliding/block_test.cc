// Claim: for any history the motion of the block obeys its laws (impulse, mirror image, scaling, no slip below the
// resistance), and its sliding distance is that by hand and by many small steps.

#include "upbead/sliding/block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace upbead {
namespace block_test {

History scaled(History history, double time, double value) {
  for (double& t : history.time) t *= time;
  for (double& f : history.value) f *= value;
  return history;
}

/// Points at random times with random values in [low, high].
History random_history(unsigned seed, int points, double low, double high) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> gap(0.01, 0.2), value(low, high);
  History history{{0.}, {value(random)}};
  for (int i = 1; i < points; ++i) {
    history.time.push_back(history.time.back() + gap(random));
    history.value.push_back(value(random));
  }
  return history;
}

/// The history at t; at a jump the value before it.
double value_at(const History& h, double t, double before, double after) {
  const auto next = std::lower_bound(h.time.begin(), h.time.end(), t) - h.time.begin();
  if (next == 0) return before;
  if (next == static_cast<std::ptrdiff_t>(h.time.size())) return after;
  const auto i = static_cast<std::size_t>(next);
  const double s = (t - h.time[i - 1]) / (h.time[i] - h.time[i - 1]);
  return (1. - s) * h.value[i - 1] + s * h.value[i];
}

/// Integral of sF - R over a slip; the integrand is linear between the points, so that the midpoint rule is exact.
double impulse(const History& force, const History& resistance, const Slip& slip) {
  std::vector<double> times{slip.start, slip.stop};
  for (const History* h : {&force, &resistance})
    for (const double t : h->time)
      if (t > slip.start && t < slip.stop) times.push_back(t);
  std::sort(times.begin(), times.end());
  const double s = slip.distance > 0. ? 1. : -1.;
  double sum = 0.;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double middle = 0.5 * (times[i] + times[i + 1]);
    const double net = s * value_at(force, middle, 0., 0.) -
                       value_at(resistance, middle, resistance.value.front(), resistance.value.back());
    sum += net * (times[i + 1] - times[i]);
  }
  return sum;
}

TEST(Block, RestsBelowTheResistance) {
  EXPECT_TRUE(slide(1., {{0., 1., 2.}, {0., 3., 0.}}, 3.).slips.empty());
  EXPECT_TRUE(slide(1., {{0., 1., 2.}, {-3., 3., -3.}}, 3.).slips.empty());
  EXPECT_FALSE(slide(1., {{0., 1., 2.}, {0., 3.0001, 0.}}, 3.).slips.empty());
}

TEST(Block, SlidesUnderAConstantForceAsByHand) {
  // F = 2R for a time T: v = R T / m, S = R T^2 / (2m) + m v^2 / (2R) = R T^2 / m, over at 2T.
  const double m = 6e5, R = 2e6, T = 0.3;
  const Sliding found = slide(m, {{0., 0., T, T}, {0., 2. * R, 2. * R, 0.}}, R);
  ASSERT_EQ(found.slips.size(), 1u);
  EXPECT_NEAR(found.residual, R * T * T / m, 1e-14);
  EXPECT_NEAR(found.slips[0].peak_velocity, R * T / m, 1e-14);
  EXPECT_NEAR(found.slips[0].stop, 2. * T, 1e-14);
}

TEST(Block, SlidesWhileItsResistanceIsLow) {
  // The force is 0.8 R; R falls to R/2 for a time T: v = 0.3 R T / m, then 0.2 R brakes.
  const double m = 1e5, R = 1e6, T = 0.4, v = 0.3 * R * T / m;
  const History force{{0., 10.}, {0.8 * R, 0.8 * R}};
  const Sliding found = slide(m, force, {{1., 1., 1. + T, 1. + T}, {R, 0.5 * R, 0.5 * R, R}});
  ASSERT_EQ(found.slips.size(), 1u);
  EXPECT_NEAR(found.slips[0].start, 1., 1e-14);
  EXPECT_NEAR(found.slips[0].stop, 1. + T + v * m / (0.2 * R), 1e-13);
  EXPECT_NEAR(found.residual, 0.5 * v * (T + v * m / (0.2 * R)), 1e-13);
}

TEST(Block, SlidesSeveralTimesAndBothWays) {
  const History force{{0., 1., 2., 10., 11., 12., 20., 21., 22.}, {0., 4., 0., 0., 4., 0., 0., -4., 0.}};
  const Sliding found = slide(1., force, 3.), once = slide(1., {{0., 1., 2.}, {0., 4., 0.}}, 3.);
  ASSERT_EQ(found.slips.size(), 3u);
  EXPECT_NEAR(found.slips[0].distance, once.residual, 1e-14);
  EXPECT_NEAR(found.slips[1].distance, once.residual, 1e-14);
  EXPECT_NEAR(found.slips[2].distance, -once.residual, 1e-14);
  EXPECT_NEAR(found.residual, once.residual, 1e-14);
  EXPECT_NEAR(found.largest, 2. * once.residual, 1e-14);
  EXPECT_NEAR(found.path, 3. * once.residual, 1e-14);
}

TEST(Block, TellsTheVelocityWithWhichItsForcesLeaveIt) {
  EXPECT_EQ(slide(2., {{0., 1., 4., 8.}, {3., 3., 0., 0.}}, 1.).end_velocity, 0.) << "it has come to rest";
  EXPECT_NEAR(slide(2., {{0., 3.}, {3., 3.}}, 1.).end_velocity, 3., 1e-14);
  EXPECT_NEAR(slide(2., {{0., 3.}, {-3., -3.}}, 1.).end_velocity, -3., 1e-14);
}

TEST(Block, TurnsWithoutRest) {
  // 2R, then -3R: the block is braked by 4R, reverses at once and slides back under 2R.
  const Sliding found = slide(1., {{0., 0., 1., 1., 3., 3.}, {0., 2., 2., -3., -3., 0.}}, 1.);
  ASSERT_EQ(found.slips.size(), 2u);
  EXPECT_NEAR(found.slips[0].stop, 1.25, 1e-14);
  EXPECT_EQ(found.slips[0].stop, found.slips[1].start);
  EXPECT_LT(found.slips[1].peak_velocity, 0.);
  EXPECT_NEAR(found.slips[1].peak_velocity, -2. * 1.75, 1e-13);
}

TEST(Block, EverySlipTakesAsMuchImpulseAsItWasGiven) {
  int slips = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const History force = random_history(seed, 30, -3., 4.), resistance = random_history(seed + 1000, 20, 0.5, 2.);
    for (const Slip& slip : slide(0.7, force, resistance).slips) {
      EXPECT_NEAR(impulse(force, resistance, slip), 0., 1e-12) << "seed " << seed;
      EXPECT_GT(slip.distance * slip.peak_velocity, 0.);
      EXPECT_GT(slip.stop, slip.start);
      ++slips;
    }
  }
  EXPECT_GT(slips, 500);
}

TEST(Block, MirroredForceMirrorsTheMotion) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const History force = random_history(seed, 30, -3., 4.);
    const Sliding a = slide(0.7, force, 1.), b = slide(0.7, scaled(force, 1., -1.), 1.);
    EXPECT_EQ(a.residual, -b.residual);
    EXPECT_EQ(a.largest, -b.largest);
    EXPECT_EQ(a.path, b.path);
  }
}

TEST(Block, DistanceScalesWithForceMassAndTime) {
  const History force = random_history(7, 30, -3., 4.);
  const Sliding a = slide(0.7, force, 1.);
  EXPECT_NEAR(slide(0.7 * 3e6, scaled(force, 1., 3e6), 3e6).residual, a.residual, 1e-12 * a.path);
  EXPECT_NEAR(slide(0.7, scaled(force, 5., 1.), 1.).residual, 25. * a.residual, 25e-12 * a.path);
}

TEST(Block, PointsThatChangeNothingChangeNothing) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const History force = random_history(seed, 30, -3., 4.);
    History refined;
    for (double t = 0.; t < force.time.back(); t += 0.003) refined.time.push_back(t);
    refined.time.insert(refined.time.end(), force.time.begin(), force.time.end());
    std::sort(refined.time.begin(), refined.time.end());
    for (const double t : refined.time) refined.value.push_back(value_at(force, t, force.value.front(), 0.));
    const Sliding a = slide(0.7, force, 1.), b = slide(0.7, refined, 1.);
    EXPECT_NEAR(a.residual, b.residual, 1e-11 * a.path) << "seed " << seed;
    EXPECT_NEAR(a.path, b.path, 1e-11 * a.path) << "seed " << seed;
  }
}

TEST(Block, AgreesWithManySmallSteps) {
  const double m = 0.7, R = 1., h = 1e-5;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const History force = random_history(seed, 30, -3., 4.);
    double x = 0., v = 0.;
    for (double t = 0.; t < force.time.back() + 20.; t += h) {
      // friction can stop the block, not reverse it
      const double free = v + h * value_at(force, t + 0.5 * h, 0., 0.) / m;
      v = std::copysign(std::max(std::abs(free) - h * R / m, 0.), free);
      x += h * v;
    }
    const Sliding found = slide(m, force, R);
    EXPECT_NEAR(found.residual, x, 1e-4 * found.path) << "seed " << seed;
  }
}

TEST(Block, ForceThatOnlyTouchesTheResistance) {
  // Round-off must cause neither a slip without end nor an endless loop.
  for (const double peak : {1., std::nextafter(1., 2.), std::nextafter(1., 0.)}) {
    const Sliding found = slide(1., {{0., 0.1, 0.3, 0.7, 1.}, {0., peak, 0.2, peak, 0.}}, 1.);
    EXPECT_LT(found.path, 1e-20);
  }
}

}  // namespace block_test
}  // namespace upbead
