// Claim: storms have the heights, numbers, tides and waves that were asked for, and the mean over lives is the
// expectation by nested quadrature.
#include "upbead/expected/life.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "caissons.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/waves/wave_heights.h"

namespace upbead::test {

namespace storm_climate_test {

StormClimate climate() {
  StormClimate c;
  c.location = 2.;
  c.scale = 1.5;
  c.shape = 1.4;
  c.steepness = 0.03;
  c.tide_low = -1.;
  c.tide_high = 1.;
  return c;
}

/// Goda's highest random breaker at the sea state's level.
double breaker(const SeaState& sea) {
  return sea_before(medium_caisson().section, medium_caisson().water, sea).heights.breaker;
}

double quadrature(const StormClimate& c, double years) {
  const Breakwater b = medium_caisson();
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  const auto of_height = [&](double u_height) {
    const auto of_tide = [&](double u_tide) {
      const SeaState sea = storm_on(b.section, b.water, c, u_height, u_tide);
      const RayleighHeights heights(sea.significant_height, RayleighHeights::no_cut, breaker(sea));
      return expected_distance(*formula_law(Law::exact, b, sea), heights, sea.waves).distance;
    };
    return Rule::integrate(of_tide, 0., 1., 2, 1e-3);
  };
  return years * c.per_year * Rule::integrate(of_height, 0., 1., 5, 1e-3);
}

LifeSetup lives_of(const StormClimate& c) {
  LifeSetup setup;
  setup.law = [](const SeaState& sea) { return formula_law(Law::exact, medium_caisson(), sea); };
  setup.limit = breaker;
  setup.source = {[c](double u) { return number_of_storms(c, 50., u); },
                  [c](double u_height, double u_tide) {
                    return storm_on(medium_caisson().section, medium_caisson().water, c, u_height, u_tide);
                  }};
  return setup;
}

TEST(StormClimate, HeightsAreWeibullOrGumbel) {
  StormClimate c = climate();
  EXPECT_NEAR(deep_water_height(c, 1. - std::exp(-1.)), 3.5, 1e-12) << "location + scale";
  EXPECT_NEAR(deep_water_height(c, 0.99), 2. + 1.5 * std::pow(-std::log(0.01), 1. / 1.4), 1e-12);
  c.kind = ExtremeKind::gumbel;
  EXPECT_NEAR(deep_water_height(c, std::exp(-1.)), 2., 1e-12) << "location";
  EXPECT_NEAR(deep_water_height(c, 0.99), 2. - 1.5 * std::log(-std::log(0.99)), 1e-12);
  EXPECT_EQ(deep_water_height(c, 1e-12), 0.01) << "below the calmest sea";
}

TEST(StormClimate, TidesLieBetweenTheirLevels) {
  StormClimate c = climate();
  EXPECT_NEAR(tide_level(c, 0.5), 0., 1e-12);
  EXPECT_NEAR(tide_level(c, 1. / 3.), -0.5, 1e-12) << "a sine stays long at its ends";
  c.tide = TideKind::uniform;
  EXPECT_NEAR(tide_level(c, 0.25), -0.5, 1e-12);
}

TEST(StormClimate, NumbersAreFixedOrThoseOfPoisson) {
  StormClimate c = climate();
  c.per_year = 0.05;
  EXPECT_EQ(number_of_storms(c, 50., 0.49), 3.);
  EXPECT_EQ(number_of_storms(c, 50., 0.51), 2.);
  c.poisson = true;
  EXPECT_EQ(number_of_storms(c, 50., std::exp(-2.5) * 0.99), 0.);
  EXPECT_EQ(number_of_storms(c, 50., std::exp(-2.5) * 1.01), 1.);
  EXPECT_EQ(number_of_storms(c, 50., std::exp(-2.5) * 3.51), 2.);
}

TEST(StormClimate, AStormRunsToTheWall) {
  const Breakwater b = medium_caisson();
  const SeaState sea = storm_on(b.section, b.water, climate(), 0.9, 0.9);
  const double deep = deep_water_height(climate(), 0.9), level = tide_level(climate(), 0.9);
  EXPECT_NEAR(sea.period * sea.period * 9.81 / (2. * std::acos(-1.)) * 0.03, deep, 1e-9);
  EXPECT_NEAR(sea.waves, 7200. / sea.period, 1e-9);
  EXPECT_EQ(sea.water_level, level);
  EXPECT_EQ(sea.significant_height, design_heights({deep, sea.period, 15. + level, 0.01}, 9.81).significant);
}

TEST(StormClimate, AStormBreaksAsTheSeaThatItCameFrom) {
  const Breakwater b = medium_caisson();
  StormClimate c = climate();
  c.location = 6.;
  for (const double u_tide : {0., 0.5, 1.}) {
    const SeaState sea = storm_on(b.section, b.water, c, 0.9, u_tide);
    const double deep = deep_water_height(c, 0.9);
    const SeaBefore before = sea_before(b.section, b.water, sea);
    EXPECT_NEAR(before.deep_water_height, deep, 1e-12 * deep);
    EXPECT_NEAR(before.heights.highest, design_heights({deep, sea.period, 15. + sea.water_level, 0.01}, 9.81).highest,
                1e-12);
    EXPECT_EQ(before.heights.highest, before.heights.breaker) << "the depth decides";
  }
}

TEST(StormClimate, LivesHaveTheExpectationOfNestedQuadrature) {
  for (const bool poisson : {false, true}) {
    StormClimate c = climate();
    c.poisson = poisson;
    c.scale = 2.5;
    const double expected = quadrature(c, 50.);
    EXPECT_GT(expected, 0.);
    std::vector<double> sliding;
    const LifeSimulation simulation(lives_of(c));
    for (std::uint32_t i = 0; i < 8000; ++i) sliding.push_back(simulation.life(i).sliding);
    const LifeStatistics s = statistics(sliding);
    EXPECT_LT(std::abs(s.mean - expected), 3. * s.standard_error);
    EXPECT_LT(s.standard_error, 0.1 * s.mean) << "the test can fail";
  }
}

}  // namespace storm_climate_test
}  // namespace upbead::test
