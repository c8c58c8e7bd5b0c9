// Claims: of many random circles none is less safe than the one that was found, on slopes, under strips and over a weak
// layer; what a strip does to the seaward side mirrors what it does to the landward one.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rupture/circle_search.h"
#include "slopes.h"

namespace upbead::test {
namespace circle_search_test {

GroundSection mound_on(const GroundSoil& lower) {
  return section_of({{soil_of(10e3, 20e3, 35.), {{-60., 0.}, {-24., 0.}, {-16., 4.}, {16., 4.}, {24., 0.}, {60., 0.}}},
                     {lower, {{-60., 0.}, {60., 0.}}},
                     {soil_of(9e3, 30e3, 20.), {{-60., -4.}, {60., -4.}}}},
                    -25.);
}

/// Circles through random points of the surface beside the strip, with random depths.
double least_of_random_circles(const GroundSection& section, const GroundLoads& loads, SlipsTo slips) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0., 1.);
  double least = 1e300;
  for (int i = 0; i < 8000; ++i) {
    const double a = loads.strip->from - 25. * std::pow(unit(random), 3.), b = loads.strip->to + 25. * unit(random);
    const double za = *section.surface(a), zb = *section.surface(b), up = std::pow(10., -1.5 + 2.5 * unit(random));
    SlipCircle circle{0.5 * (a + b) - up * (zb - za), 0.5 * (za + zb) + up * (b - a), 0.};
    if (circle.y < std::max(za, zb)) continue;
    circle.radius = std::hypot(circle.x - a, circle.y - za);
    least = std::min(least, circle_safety(section, loads, circle, slips, a, b, 200).factor);
  }
  return least;
}

TEST(CircleSearch, MissesNoCircle) {
  for (const GroundSoil& lower : {soil_of(9e3, 30e3, 20.), soil_of(8e3, 15e3, 0.), soil_of(10e3, 0., 38.)})
    for (const double moment : {0., 4e6}) {
      const GroundSection section = mound_on(lower);
      GroundLoads loads;
      loads.strip = effective_strip(1.5e6, moment, 0.15 * moment, -9., 9., 4.);
      const CircleSearch found = search_circles(section, loads, SlipsTo::right, range_beside(section, *loads.strip));
      ASSERT_FALSE(found.family.empty());
      const double F = found.family[0].safety.factor;
      EXPECT_LT(F, 1.002 * least_of_random_circles(section, loads, SlipsTo::right)) << lower.cohesion << ' ' << moment;
      for (const FoundCircle& other : found.family) EXPECT_GE(other.safety.factor, F);
    }
}

TEST(CircleSearch, IsMirrored) {
  const GroundSection section = mound_on(soil_of(9e3, 25e3, 10.));
  GroundLoads right, left;
  right.strip = effective_strip(1.5e6, 3e6, 0.4e6, -9., 9., 4.);
  left.strip = effective_strip(1.5e6, -3e6, -0.4e6, -9., 9., 4.);
  // the ranges are mirrored, too: how far a circle goes to the left of the strip, and to its right
  const auto a = search_circles(section, right, SlipsTo::right, range_beside(section, *right.strip)).family;
  const auto b = search_circles(section, left, SlipsTo::left, range_beside(section, *left.strip)).family;
  ASSERT_FALSE(a.empty() || b.empty());
  EXPECT_NEAR(a[0].safety.factor, b[0].safety.factor, 2e-3 * a[0].safety.factor);
}

}  // namespace circle_search_test
}  // namespace upbead::test
