// Claims: F agrees with an integral along the arc, by its angle, that shares no code with it, to 1e-3; in water,
// submerged weights say the same as whole weights with all pressures; a mirrored section is as safe; slices converge;
// what no circle may do is told.

#include <gtest/gtest.h>

#include <cmath>

#include "rupture/slip_circle.h"
#include "slopes.h"

namespace upbead::test {
namespace slip_circle_test {

constexpr double water = 10e3, level = 6.;  // N/m3, m

/// The surface of a mound and what is below it; a strip stands on its crest.
double top_of(double x) {
  return x < 0. ? 8. : x < 12. ? 8. - x / 1.5 : 0.;
}
double clay_top_of(double x) {
  return 1. - 0.1 * x;
}

GroundSoil stone() {
  GroundSoil s = soil_of(18e3, 20e3, 35.);
  s.submerged = 10e3;
  return s;
}
GroundSoil clay() {
  GroundSoil s = soil_of(17e3, 45e3, 12.);
  s.submerged = 7e3;
  return s;
}

GroundSection mound(bool mirrored = false, bool whole_weights = false) {
  Polyline top{{-40., 8.}, {0., 8.}, {12., 0.}, {40., 0.}}, low{{-40., 5.}, {10., 0.}, {40., -3.}};
  low[1][1] = clay_top_of(10.);
  if (mirrored)
    for (Polyline* line : {&top, &low}) {
      for (auto& point : *line) point[0] *= -1.;
      std::reverse(line->begin(), line->end());
    }
  GroundSoil upper = stone(), lower = clay();
  if (whole_weights)
    for (GroundSoil* soil : {&upper, &lower}) soil->submerged += water;
  return section_of({{upper, top}, {lower, low}}, -30., level);
}

GroundLoads loads_of(double side = 1.) {
  GroundLoads loads;
  loads.strip = side > 0. ? StripLoad{-9., -2., 150e3, 250e3, 300e3, 8.} : StripLoad{2., 9., 250e3, 150e3, -300e3, 8.};
  loads.pressure = [side](double x, double y) {
    return 20e3 * std::exp(-0.1 * std::abs(side * x + 8.)) * (1. + 0.02 * y);
  };
  loads.acceleration = 0.05 * side;
  return loads;
}

constexpr SlipCircle circle{4., 14., 17.};

/// F by Simpson's rule over the angle from the vertical, and bisection.
double by_the_angle() {
  const GroundLoads loads = loads_of();
  const double first = circle.x - std::sqrt(17. * 17. - 36.), last = circle.x + std::sqrt(17. * 17. - 14. * 14.);
  const double from = std::asin((first - circle.x) / 17.), to = std::asin((last - circle.x) / 17.);
  const int n = 200000;
  const auto integral = [&](const std::function<double(double, double, double)>& f) {  // of (x, y, angle) dx
    double sum = 0.;
    for (int i = 0; i <= n; ++i) {
      const double angle = from + (to - from) * i / n;
      const double weight = i == 0 || i == n ? 1. : i % 2 ? 4. : 2.;
      sum +=
          weight * f(circle.x + 17. * std::sin(angle), circle.y - 17. * std::cos(angle), angle) * 17. * std::cos(angle);
    }
    return sum * (to - from) / n / 3.;
  };
  const auto piece = [](double high, double low, const GroundSoil& soil, double moment) {
    const double above = std::max(high, level), under = std::min(low, level), cut_low = std::max(low, level);
    const double cut_high = std::min(high, level);
    double w = 0.;
    if (above > cut_low && high > level)
      w += soil.weight * (high - cut_low) * (moment > 0. ? 0.5 * (high + cut_low) : 1.);
    if (cut_high > under) w += soil.submerged * (cut_high - low) * (moment > 0. ? 0.5 * (cut_high + low) : 1.);
    return w;
  };
  const auto weight = [&](double x, double y, double moment) {
    const double top = top_of(x), clay_top = std::min(clay_top_of(x), top);
    if (y >= clay_top) return piece(top, y, stone(), moment);
    return (top > clay_top ? piece(top, clay_top, stone(), moment) : 0.) + piece(clay_top, y, clay(), moment);
  };
  const auto strip = [&](double x) { return x > -9. && x < -2. ? 150e3 + 100e3 * (x + 9.) / 7. : 0.; };
  const double driving = integral([&](double x, double y, double) {
                           const double p = loads.pressure(x, top_of(x)), slope = x > 0. && x < 12. ? -1. / 1.5 : 0.;
                           return (weight(x, y, 0.) + strip(x) + p) * (circle.x - x) +
                                  p * slope * (circle.y - top_of(x)) +
                                  0.05 * (circle.y * weight(x, y, 0.) - weight(x, y, 1.));
                         }) +
                         300e3 * (circle.y - 8.);
  const auto rest = [&](double F) {
    return integral([&](double x, double y, double angle) {
             const GroundSoil soil = y < clay_top_of(x) ? clay() : stone();
             const double normal = weight(x, y, 0.) + strip(x) + loads.pressure(x, top_of(x)) - loads.pressure(x, y);
             return 17. * std::max(soil.cohesion + normal * soil.friction, 0.) /
                    (std::cos(angle) - std::sin(angle) * soil.friction / F);
           }) / driving -
           F;
  };
  double low = 0.3, high = 10.;
  for (int i = 0; i < 40; ++i) (rest(0.5 * (low + high)) > 0. ? low : high) = 0.5 * (low + high);
  return low;
}

TEST(SlipCircle, AgreesWithAnIntegralByTheAngle) {
  const FigureSafety found = circle_safety(mound(), loads_of(), circle, SlipsTo::right, 4000);
  EXPECT_EQ(found.why, NoFactor::none);
  EXPECT_NEAR(found.from, circle.x - std::sqrt(17. * 17. - 36.), 1e-6);
  EXPECT_NEAR(found.factor / by_the_angle(), 1., 1e-3);
}

TEST(SlipCircle, OfAMirroredSectionIsAsSafe) {
  const double F = circle_safety(mound(), loads_of(), circle, SlipsTo::right, 500).factor;
  SlipCircle mirrored = circle;
  mirrored.x *= -1.;
  EXPECT_NEAR(circle_safety(mound(true), loads_of(-1.), mirrored, SlipsTo::left, 500).factor, F, 1e-5 * F);
}

TEST(SlipCircle, SaysTheSameOfSubmergedWeightsAsOfAllPressures) {
  GroundLoads loads = loads_of();
  loads.acceleration = 0.;
  const double submerged = circle_safety(mound(), loads, circle, SlipsTo::right, 4000).factor;
  loads.pressure = [of = loads.pressure](double x, double y) { return of(x, y) + water * std::max(level - y, 0.); };
  EXPECT_NEAR(circle_safety(mound(false, true), loads, circle, SlipsTo::right, 4000).factor / submerged, 1., 1e-3);
}

/// One slice is of one soil, so that the error falls as the width of a slice.
TEST(SlipCircle, ConvergesWithItsSlices) {
  const auto F = [](int n) { return circle_safety(mound(), loads_of(), circle, SlipsTo::right, n).factor; };
  const double truth = F(40000);
  EXPECT_LT(std::abs(F(40) / truth - 1.), 2e-2);
  EXPECT_LT(std::abs(F(400) / truth - 1.), 2e-3);
  EXPECT_LT(std::abs(F(4000) / truth - 1.), 2e-4);
}

TEST(SlipCircle, TellsWhyItHasNoFactor) {
  const auto why = [](const GroundSection& section, const GroundLoads& loads, const SlipCircle& c, SlipsTo slips) {
    return circle_safety(section, loads, c, slips, 100).why;
  };
  EXPECT_EQ(why(mound(), {}, circle, SlipsTo::left), NoFactor::nothing_drives);
  EXPECT_EQ(why(mound(), {}, {0., 45., 100.}, SlipsTo::right), NoFactor::outside);
  GroundLoads split;
  split.strip = {-20., -2., 1e5, 1e5, 0., 8.};
  EXPECT_EQ(why(mound(), split, circle, SlipsTo::right), NoFactor::uncut);
  GroundSoil rock = clay();
  rock.may_fail = false;
  const GroundSection on_rock =
      section_of({{stone(), {{-40., 8.}, {0., 8.}, {12., 0.}, {40., 0.}}}, {rock, {{-40., 0.}, {40., 0.}}}}, -30.);
  EXPECT_EQ(why(on_rock, {}, circle, SlipsTo::right), NoFactor::uncut);
  const GroundSection sand = section_of({{soil_of(18e3, 0., 40.), {{-40., 0.}, {40., 0.}}}}, -30.);
  GroundLoads strip;
  strip.strip = {-9., -2., 1e6, 1e6, 0., 0.};
  EXPECT_EQ(why(sand, strip, {0., 1., 12.}, SlipsTo::right), NoFactor::steep);
}

TEST(SlipCircle, TakesTheLoadOfABaseOnItsEffectiveWidth) {
  const auto strip = effective_strip(1000., 1500., 300., -5., 5., 2.);
  ASSERT_TRUE(strip);
  EXPECT_DOUBLE_EQ(strip->from, -2.);
  EXPECT_DOUBLE_EQ(strip->to, 5.);
  EXPECT_DOUBLE_EQ(strip->at_from, 1000. / 7.);
  EXPECT_DOUBLE_EQ(strip->at_to, 1000. / 7.);
  EXPECT_DOUBLE_EQ(effective_strip(1000., -1500., 300., -5., 5., 2.)->to, 2.);
  EXPECT_FALSE(effective_strip(1000., 5000., 0., -5., 5., 0.));
  EXPECT_FALSE(effective_strip(-1., 0., 0., -5., 5., 0.));
}

}  // namespace slip_circle_test
}  // namespace upbead::test
