// Claim: the closed forms of the triangular pulse have the right limits, are continuous at their common bounds, and
// scale.

#include "upbead/sliding/pulse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace upbead {
namespace pulse_test {

constexpr double mass = 6e5, resistance = 1.9e6, duration = 0.2;

double paper(double r) {
  return sliding_distance_paper(mass, resistance, {r * resistance, duration});
}
double exact(double r) {
  return sliding_distance_exact(mass, resistance, {r * resistance, duration});
}

TEST(Pulse, SlidesOnlyAboveTheResistance) {
  for (const double r : {-2., 0., 0.5, 1.}) {
    EXPECT_EQ(paper(r), 0.);
    EXPECT_EQ(exact(r), 0.);
  }
  EXPECT_GT(paper(1.001), 0.);
}

TEST(Pulse, Equation7IsLowBy94PercentAtTheThresholdAndRightFarAboveIt) {
  EXPECT_NEAR(exact(1. + 1e-6) / paper(1. + 1e-6), 1. + 2. * std::sqrt(2.) / 3., 1e-5);
  EXPECT_NEAR(exact(1e3) / paper(1e3), 1., 3e-3);
}

TEST(Pulse, BothBranchesMeet) {
  const double r = 1. + std::sqrt(0.5);
  EXPECT_NEAR(exact(r * (1. + 1e-12)) / exact(r * (1. - 1e-12)), 1., 1e-10);
}

TEST(Pulse, MassAndDurationScaleTheDistance) {
  const double S = sliding_distance_exact(mass, resistance, {2. * resistance, duration});
  EXPECT_NEAR(sliding_distance_exact(2. * mass, resistance, {2. * resistance, duration}), S / 2., 1e-14 * S);
  EXPECT_NEAR(sliding_distance_exact(mass, resistance, {2. * resistance, 3. * duration}), 9. * S, 1e-14 * S);
}

TEST(Pulse, Equation7IsTheSumOfItsParts) {
  for (const double r : {0.9, 1.05, 1.5, 3.}) {
    const PaperParts parts = sliding_distance_paper_parts(mass, resistance, {r * resistance, duration});
    EXPECT_NEAR(parts.accelerating + parts.braking, paper(r), 1e-14 * paper(r));
    // S_1 is V (t_2 - t_1) / 2 with V = duration (F - R)^2 / (2 mass F) and t_2 - t_1 = duration (1 - 1/r)
    const double V = r > 1. ? duration * std::pow((r - 1.) * resistance, 2) / (2. * mass * r * resistance) : 0.;
    EXPECT_NEAR(parts.accelerating, 0.5 * V * duration * (1. - 1. / r), 1e-14 * paper(r));
  }
}

TEST(Pulse, IsATriangle) {
  const History points = history({3., 4.});
  EXPECT_EQ(points.time, (std::vector<double>{0., 2., 4.}));
  EXPECT_EQ(points.value, (std::vector<double>{0., 3., 0.}));
}

TEST(Pulse, RefusesWhatIsNotPositive) {
  for (const auto distance : {sliding_distance_paper, sliding_distance_exact}) {
    EXPECT_THROW(distance(0., resistance, {1., 1.}), std::invalid_argument);
    EXPECT_THROW(distance(mass, 0., {1., 1.}), std::invalid_argument);
    EXPECT_THROW(distance(mass, resistance, {1., -1.}), std::invalid_argument);
  }
}

}  // namespace pulse_test
}  // namespace upbead
