// Claims: a circle whose slices stay has the factor that the circle has by itself, with and without pore pressure,
// however the effective width lies on its slices; a circle that would leave a part of that width has none; the least of
// a family is the least of its circles that may go that way; a base whose resultant leaves it has the factor 0.
#include "upbead/rupture/circle_family.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rupture/fixed_circle.h"
#include "slopes.h"

namespace upbead::test {
namespace circle_family_test {

GroundSection mound_on_sand() {
  return section_of({{soil_of(10e3, 20e3, 35.), {{-60., 0.}, {-24., 0.}, {-16., 4.}, {16., 4.}, {24., 0.}, {60., 0.}}},
                     {soil_of(9e3, 5e3, 32.), {{-60., 0.}, {60., 0.}}}},
                    -25.);
}

double pressure(double x, double y) {
  return 8e3 * std::exp(0.1 * (y - 4.)) * (1. + 0.02 * x);
}

/// A circle between those ends, `rise` times their distance above them.
SlipCircle circle_through(const GroundSection& section, double from, double to, double rise) {
  const double a = *section.surface(from), b = *section.surface(to);
  SlipCircle circle{0.5 * (from + to) - rise * (b - a), 0.5 * (a + b) + rise * (to - from), 0.};
  circle.radius = std::hypot(circle.x - from, circle.y - a);
  return circle;
}

struct Sample {
  CircleFamily family;
  Eigen::VectorXd readings;
};

/// A family of circles both ways, with the readings of pressure().
Sample sample(const GroundSection& section, int slices) {
  Sample s;
  s.family.left = -9.;
  s.family.right = 9.;
  s.family.level = 4.;
  std::vector<double> list;
  for (const SlipsTo slips : {SlipsTo::right, SlipsTo::left})
    for (const double from : {-10., 0., 4.}) {
      const double a = slips == SlipsTo::right ? from : -21., b = slips == SlipsTo::right ? 21. : -from;
      const FamilyCircle circle = *family_circle(section, {}, circle_through(section, a, b, 0.35), slips, a, b, slices);
      double moment = 0.;
      for (const SliceReading& r : readings_of(section, circle)) {
        list.push_back(pressure(r.surface[0], r.surface[1]) - pressure(r.base[0], r.base[1]));
        moment += r.moment_per_pressure * pressure(r.surface[0], r.surface[1]);
      }
      list.push_back(moment);
      s.family.circles.push_back(circle);
    }
  s.readings = Eigen::Map<Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(list.size()));
  return s;
}

/// Largest difference from the circles by themselves, relative.
double difference(int n_slices) {
  const GroundSection section = mound_on_sand();
  const Sample s = sample(section, n_slices);
  double most = 0.;
  EXPECT_EQ(s.family.n_readings(), static_cast<std::size_t>(s.readings.size()));
  int compared = 0;
  for (const double e : {0., 3.3, 5.1, 7.2, -4.7})
    for (const bool pressed : {false, true}) {
      const double N = 1.5e6, F = e < 0. ? -2.5e5 : 2.5e5;
      GroundLoads loads;
      loads.strip = effective_strip(N, N * e, F, -9., 9., 4.);
      if (pressed) loads.pressure = pressure;
      const double* readings = s.readings.data();
      for (std::size_t i = 0; i < s.family.circles.size(); ++i) {
        const FamilyCircle& c = s.family.circles[i];
        const auto factor = factor_of(s.family, i, {N, F, N * e}, pressed ? readings : nullptr);
        readings += c.n_readings();
        const FigureSafety whole = circle_safety(section, loads, {c.x, c.y, c.radius},
                                                 c.landward ? SlipsTo::right : SlipsTo::left, c.from, c.to, 4000);
        EXPECT_EQ(factor.has_value(), whole.why == NoFactor::none) << e << ' ' << i;
        if (!factor) continue;
        most = std::max(most, std::abs(*factor / whole.factor - 1.));
        ++compared;
      }
    }
  EXPECT_GT(compared, 15);
  return most;
}

TEST(CircleFamily, HasTheFactorsOfItsCirclesByThemselves) {
  EXPECT_LT(difference(40), 1e-2) << "as many slices as in a model";
  EXPECT_LT(difference(1000), 1e-3);
}

TEST(CircleFamily, ConvergesWithItsSlices) {
  const GroundSection section = mound_on_sand();
  const BaseLoad load{1.5e6, 2.5e5, 1.5e6 * 7.1};
  const double coarse = *factor_of(sample(section, 20).family, 1, load, nullptr);
  const double fine = *factor_of(sample(section, 80).family, 1, load, nullptr);
  const double limit = *factor_of(sample(section, 3000).family, 1, load, nullptr);
  EXPECT_LT(std::abs(fine - limit), 0.5 * std::abs(coarse - limit));
}

TEST(CircleFamily, GivesTheLeastOfThoseThatMayGo) {
  const Sample s = sample(mound_on_sand(), 40);
  const double N = 1.5e6;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto factor = factor_of(s.family, i, {N, 3e5, N * 7.}, nullptr)) least = std::min(least, *factor);
  const auto landward = least_factor(s.family, {N, 3e5, N * 7.}, nullptr);
  ASSERT_TRUE(landward);
  EXPECT_EQ(landward->factor, least);
  EXPECT_TRUE(s.family.circles[landward->circle].landward);
  const auto seaward = least_factor(s.family, {N, -3e5, -N * 7.}, nullptr);
  ASSERT_TRUE(seaward);
  EXPECT_FALSE(s.family.circles[seaward->circle].landward);
  EXPECT_NEAR(seaward->factor, landward->factor, 1e-9) << "the section is symmetric";
}

TEST(CircleFamily, TellsABaseThatTheResultantLeaves) {
  const Sample s = sample(mound_on_sand(), 20);
  EXPECT_EQ(least_factor(s.family, {1e6, 1e5, 9.2e6}, nullptr)->factor, 0.);
  EXPECT_EQ(least_factor(s.family, {-1e3, 1e5, 0.}, nullptr)->factor, 0.);
  const auto none = [](const std::vector<std::size_t>& moments) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::Zero(1, static_cast<Eigen::Index>(moments.size()));
  };
  const auto wave = circle_of_wave(s.family, {1e6, 1e6, 1e6}, {0., 9.2e6, 0.}, {0., 1e5, 0.}, none);
  ASSERT_TRUE(wave);
  EXPECT_EQ(wave->factor, 0.);
  EXPECT_EQ(wave->moment, 1U);
}

TEST(CircleFamily, LooksAtTheMomentsThatMayGovern) {
  const std::vector<double> force{5., 4., 3., 5., 6.}, moment{0., 1., 1.5, -2.4, 0.}, shear{0., 3., 2.9, 1., -4.};
  // largest F_T: 1, least: 4, largest |M'/N'|: 2 (0.5), largest |F_T|/N': 2, least N': 2; 3 has |e| of 0.48
  const std::vector<std::size_t> expected{1, 2, 4};
  EXPECT_EQ(moments_that_may_govern(force, moment, shear, 10.), expected);
  EXPECT_FALSE(first_without_stand(force, moment, 10.));
  EXPECT_EQ(first_without_stand(force, moment, 0.97), std::optional<std::size_t>(2));
}

}  // namespace circle_family_test
}  // namespace upbead::test
