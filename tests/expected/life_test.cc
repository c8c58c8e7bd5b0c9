// Claim: lives by Monte Carlo have the expectation by quadrature, in whichever way and order they are drawn.
#include "upbead/expected/life.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <thread>

#include "caissons.h"
#include "upbead/expected/sliding_law.h"

namespace upbead::test {

namespace life_test {

LawMaker exact() {
  return [](const SeaState& sea) { return formula_law(Law::exact, medium_caisson(), sea); };
}

/// A record of a day with a storm and calmer seas.
LifeSetup setup(std::uint64_t seed = 1) {
  LifeSetup s;
  s.states = {storm(6.), storm(4.), {1., 8., 1e6, 0., 0.}};
  s.record_years = s.life_years = 1.;
  s.law = exact();
  s.seed = seed;
  return s;
}

Scatter normal(double mean, double cov, Per per) {
  Scatter s;
  s.mean = mean;
  s.cov = cov;
  s.per = per;
  return s;
}

double quadrature(double friction = 1.) {
  double sum = 0.;
  for (const SeaState& state : setup().states) {
    Breakwater caisson = medium_caisson();
    caisson.section.friction *= friction;
    sum += expected_distance(*formula_law(Law::exact, caisson, state), RayleighHeights(state.significant_height),
                             state.waves)
               .distance;
  }
  return sum;
}

std::vector<double> lives(const LifeSimulation& simulation, std::uint32_t n) {
  std::vector<double> sliding;
  for (std::uint32_t i = 0; i < n; ++i) sliding.push_back(simulation.life(i).sliding);
  return sliding;
}

/// Deviation of the mean from `expected`, in standard errors.
double off(const LifeSimulation& simulation, std::uint32_t n, double expected) {
  const LifeStatistics s = statistics(lives(simulation, n));
  return std::abs(s.mean - expected) / s.standard_error;
}

/// Largest difference of two empirical distribution functions.
double kolmogorov(std::vector<double> a, std::vector<double> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  double most = 0.;
  for (const double x : a) {
    const auto below_a = std::upper_bound(a.begin(), a.end(), x) - a.begin();
    const auto below_b = std::upper_bound(b.begin(), b.end(), x) - b.begin();
    most = std::max(most, std::abs(static_cast<double>(below_a) / static_cast<double>(a.size()) -
                                   static_cast<double>(below_b) / static_cast<double>(b.size())));
  }
  return most;
}

TEST(LifeSimulation, AgreesWithQuadratureInItsOwnInterval) {
  const double expected = quadrature();
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const LifeStatistics s = statistics(lives(LifeSimulation(setup(seed)), 1000));
    if (s.interval[0] <= expected && expected <= s.interval[1]) ++inside;
  }
  EXPECT_GE(inside, 88);
}

TEST(LifeSimulation, DrawingOnlySlidingWavesIsTheSameAsDrawingAll) {
  LifeSetup few = setup();
  few.states = {storm(6.), storm(5.)};
  LifeSetup every = few;
  every.every_wave = true;
  const std::uint32_t n = 10000;
  const double distance = kolmogorov(lives(LifeSimulation(few), n), lives(LifeSimulation(every), n));
  EXPECT_LT(distance, 1.95 * std::sqrt(2. / n)) << "Kolmogorov and Smirnov, two samples, 0.1 %";
  few.cut = 1.7;
  EXPECT_GT(kolmogorov(lives(LifeSimulation(few), n), lives(LifeSimulation(every), n)), 1.95 * std::sqrt(2. / n))
      << "the test sees other heights";
}

TEST(LifeSimulation, DoesNotDependOnThreadsOrOrder) {
  LifeSetup s = setup();
  s.uncertain.force = Distribution(normal(1., 0.1, Per::wave), 1.);
  s.uncertain.friction = Distribution(normal(1., 0.1, Per::life), 1.);
  s.uncertain.significant_height = Distribution(normal(1., 0.1, Per::storm), 1.);
  s.states.pop_back();
  const LifeSimulation simulation(s);
  const std::vector<double> one = lives(simulation, 64);
  for (const std::size_t n_threads : {2U, 4U}) {
    std::vector<double> many(one.size());
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < n_threads; ++t)
      threads.emplace_back([&, t] {
        for (std::size_t i = one.size(); i-- > 0;)
          if (i % n_threads == t) many[i] = simulation.life(static_cast<std::uint32_t>(i)).sliding;
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(many, one) << n_threads << " threads, to the last bit";
  }
  EXPECT_NE(lives(LifeSimulation(setup(2)), 64), lives(LifeSimulation(setup(3)), 64)) << "another seed";
}

TEST(LifeSimulation, AScatterWithoutDeviationChangesNothing) {
  LifeSetup s = setup();
  for (const auto quantity : {&Uncertainties::force, &Uncertainties::uplift, &Uncertainties::friction,
                              &Uncertainties::weight, &Uncertainties::significant_height, &Uncertainties::period})
    s.uncertain.*quantity = Distribution(normal(1., 0., Per::storm), 1.);
  Scatter level;
  level.deviation = 0.;
  s.uncertain.water_level = Distribution(level, 0.);
  EXPECT_EQ(lives(LifeSimulation(s), 200), lives(LifeSimulation(setup()), 200));
}

TEST(LifeSimulation, FrictionThatScattersShiftsTheMeanAsNestedQuadratureSays) {
  LifeSetup s = setup();
  s.uncertain.friction = Distribution(normal(1., 0.1, Per::life), 1.);
  const auto integrand = [](double z) {
    return quadrature(1. + 0.1 * z) * std::exp(-0.5 * z * z) / std::sqrt(2. * M_PI);
  };
  const double expected = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, -5., 5., 3, 1e-6);
  EXPECT_GT(expected, 1.1 * quadrature()) << "uncertainty costs distance";
  EXPECT_LT(off(LifeSimulation(s), 20000, expected), 3.);
  s.uncertain.friction = Distribution(normal(1., 0.1, Per::storm), 1.);
  EXPECT_LT(off(LifeSimulation(s), 20000, expected), 3.) << "the mean does not ask how long a draw holds";
}

TEST(LifeSimulation, ScatterFromWaveToWaveHasTheSameMean) {
  LifeSetup s = setup();
  s.states = {storm(6.)};
  s.uncertain.force = Distribution(normal(1., 0.1, Per::storm), 1.);
  const LifeStatistics by_storm = statistics(lives(LifeSimulation(s), 20000));
  s.uncertain.force = Distribution(normal(1., 0.1, Per::wave), 1.);
  const LifeStatistics by_wave = statistics(lives(LifeSimulation(s), 2000));
  EXPECT_NEAR(by_storm.mean, by_wave.mean, 3. * std::hypot(by_storm.standard_error, by_wave.standard_error));
  EXPECT_LT(by_wave.standard_error * std::sqrt(2000.), by_storm.standard_error * std::sqrt(20000.))
      << "but a life scatters less";
}

TEST(LifeSimulation, AFactorOfTheHeightIsALargerSea) {
  LifeSetup s = setup();
  s.states = {storm(5.)};
  s.uncertain.wave = Distribution(normal(1.2, 0., Per::storm), 1.);
  const double expected =
      expected_distance(*formula_law(Law::exact, medium_caisson(), storm(5.)), RayleighHeights(6.), 600.).distance;
  EXPECT_LT(off(LifeSimulation(s), 5000, expected), 3.);
}

TEST(LifeSimulation, ALifeIsTheRecordOverAndOver) {
  LifeSetup s = setup();
  s.record_years = 9.;
  s.life_years = 50.;
  const LifeSimulation simulation(s);
  EXPECT_EQ(simulation.storms(), 18U);
  EXPECT_NEAR(simulation.life(0).waves, 50. / 9. * (1e6 + 1200.), 1.5);
  EXPECT_LT(off(simulation, 3000, 50. / 9. * quadrature()), 3.);
}

TEST(LifeSimulation, WavesBeyondTheCutDoNotSlide) {
  LifeSetup s = setup();
  s.states = {storm(6.)};
  s.cut = 1.8;
  const double expected =
      expected_distance(*formula_law(Law::exact, medium_caisson(), storm(6.)), RayleighHeights(6., 1.8), 600.).distance;
  EXPECT_LT(off(LifeSimulation(s), 3000, expected), 3.);
  s.every_wave = true;
  EXPECT_LT(off(LifeSimulation(s), 3000, expected), 3.);
}

TEST(LifeSimulation, WavesThatBreakSlideAsQuadratureSays) {
  LifeSetup s = setup();
  s.states = {storm(6.)};
  for (const double limit : {10., 11.}) {
    s.limit = [limit](const SeaState&) { return limit; };
    const RayleighHeights heights(6., RayleighHeights::no_cut, limit);
    const double expected =
        expected_distance(*formula_law(Law::exact, medium_caisson(), storm(6.)), heights, 600.).distance;
    for (const bool every_wave : {false, true}) {
      s.every_wave = every_wave;
      const LifeSimulation simulation(s);
      const std::uint32_t n = every_wave ? 3000 : 12000;
      EXPECT_LT(off(simulation, n, expected), 3.) << limit;
      double taken = 0., highest = 0.;
      for (std::uint32_t i = 0; i < n; ++i) {
        const Life life = simulation.life(i);
        taken += life.taken;
        highest = std::max(highest, life.highest);
      }
      const double broken = n * 600. * heights.at_limit();
      EXPECT_LT(std::abs(taken - broken), 4. * std::sqrt(broken)) << limit;
      EXPECT_EQ(highest, limit) << "none is higher, some get there";
    }
  }
}

TEST(LifeSimulation, WavesThatBreakWithoutSlidingAreCounted) {
  LifeSetup s = setup();
  s.states = {storm(6.)};
  s.limit = [](const SeaState&) { return 7.; };
  for (const bool every_wave : {false, true}) {
    s.every_wave = every_wave;
    const LifeSimulation simulation(s);
    double taken = 0.;
    for (std::uint32_t i = 0; i < 300; ++i) {
      EXPECT_EQ(simulation.life(i).sliding, 0.);
      taken += simulation.life(i).taken;
    }
    const double broken = 300 * 600. * std::exp(-2. * 49. / 36.);
    EXPECT_LT(std::abs(taken - broken), 4. * std::sqrt(broken));
  }
}

TEST(LifeSimulation, WavesBeyondTheCutAreCounted) {
  LifeSetup s = setup();
  s.states = {storm(6.)};
  s.cut = 1.4;
  for (const bool every_wave : {false, true}) {
    s.every_wave = every_wave;
    double taken = 0.;
    for (std::uint32_t i = 0; i < 300; ++i) taken += LifeSimulation(s).life(i).taken;
    const double beyond = 300 * 600. * std::exp(-2. * 1.4 * 1.4);
    EXPECT_LT(std::abs(taken - beyond), 4. * std::sqrt(beyond));
  }
}

TEST(LifeSimulation, TheLimitHoldsForHeightsWithTheirFactorAndForSeasAsDrawn) {
  LifeSetup s = setup();
  s.states = {storm(5.)};
  s.uncertain.wave = Distribution(normal(1.2, 0., Per::storm), 1.);
  Scatter level;
  level.kind = ScatterKind::uniform;
  level.low = -1.;
  level.high = 1.;
  s.uncertain.water_level = Distribution(level, 0.);
  s.limit = [](const SeaState& sea) { return 9.5 + sea.water_level; };
  const auto at_level = [](double rise) {
    SeaState sea = storm(5.);
    sea.water_level = rise;
    const RayleighHeights heights(6., RayleighHeights::no_cut, 9.5 + rise);
    return 0.5 * expected_distance(*formula_law(Law::exact, medium_caisson(), sea), heights, 600.).distance;
  };
  const double expected = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(at_level, -1., 1., 5, 1e-8);
  EXPECT_GT(expected, 0.);
  EXPECT_LT(off(LifeSimulation(s), 5000, expected), 3.);
  s.every_wave = true;
  EXPECT_LT(off(LifeSimulation(s), 1500, expected), 3.);
}

TEST(LifeSimulation, SeaStatesCannotScatterFromWaveToWave) {
  LifeSetup s = setup();
  s.uncertain.period = Distribution(normal(1., 0.1, Per::wave), 1.);
  EXPECT_THROW(LifeSimulation{s}, std::invalid_argument);
}

}  // namespace life_test
}  // namespace upbead::test
