// Claim: S of all waves of lives by a dear measure, estimated from few waves, has the error that is told.
#include "expected/wave_sample.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "caissons.h"

namespace upbead::test {

namespace wave_sample_test {

constexpr int n_lives = 30, everything = 1000000;

Breakwater caisson_of(double friction) {
  Breakwater caisson = medium_caisson();
  caisson.section.friction *= friction;
  return caisson;
}

Scatter scatter(double cov) {
  Scatter s;
  s.mean = 1.;
  s.cov = cov;
  s.per = Per::wave;
  return s;
}

LifeSetup lives(std::uint64_t seed, double friction = 1.) {
  LifeSetup s;
  s.states = {storm(6.), storm(5.)};
  s.record_years = s.life_years = 1.;
  s.law = [friction](const SeaState& sea) { return formula_law(Law::exact, caisson_of(friction), sea); };
  s.uncertain.force.emplace(scatter(0.1), 1.);
  s.seed = seed;
  return s;
}

/// A measure that slides also where the law does not, and by other amounts from wave to wave.
std::vector<DearSlip> dear(const WaveSample& sample, double friction = 1.) {
  std::vector<DearSlip> slips;
  for (const SampledWave& one : sample.waves) {
    const DrawnWave& w = one.wave;
    WaveFactors more = w.factors;
    more.friction *= 0.85;
    const double S = formula_law(Law::exact, caisson_of(friction), w.sea)->distance(w.height, more);
    slips.push_back({S * (0.5 + 0.2 * std::sin(40. * w.height)), 0.01 * S, ""});
  }
  return slips;
}

TEST(WaveSample, HasTheSumOfAllWavesWithinWhatIsTold) {
  constexpr int n = 40;
  double z_sum = 0., told = 0.;
  int within = 0;
  for (std::uint64_t seed = 1; seed <= n; ++seed) {
    const WaveSample all = sample_waves(lives(seed), n_lives, everything), few = sample_waves(lives(seed), n_lives, 60);
    ASSERT_TRUE(all.is_whole);
    ASSERT_FALSE(few.is_whole);
    EXPECT_EQ(few.draws.size(), 60u);
    EXPECT_NEAR(few.block, all.block, 1e-12 * all.block);
    const DearSum truth = estimate(all, dear(all)), found = estimate(few, dear(few));
    EXPECT_EQ(truth.standard_error, 0.);
    const double z = (found.sum - truth.sum) / found.standard_error;
    z_sum += z;
    told += found.standard_error / truth.sum / n;
    if (std::abs(z) < quantile(boost::math::students_t(found.freedom), 0.975)) ++within;
  }
  EXPECT_LT(std::abs(z_sum) / std::sqrt(n), 3.);
  EXPECT_GE(within, n - 7);  // fewer in one of 300 such tests: 38 are expected
  EXPECT_LT(told, 0.15);
}

TEST(WaveSample, SeesWhatManyWavesAddThatSlideNoBlock) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const WaveSample all = sample_waves(lives(seed), n_lives, everything), few = sample_waves(lives(seed), n_lives, 60);
    const auto more = [](const WaveSample& sample) {
      std::vector<DearSlip> slips = dear(sample);
      for (DearSlip& slip : slips) slip.sliding += 0.003;
      return estimate(sample, slips);
    };
    const DearSum truth = more(all), found = more(few);
    EXPECT_GT(truth.sum, 1.2 * estimate(all, dear(all)).sum);
    EXPECT_LT(std::abs(found.sum - truth.sum), 3.5 * found.standard_error) << seed;
    EXPECT_LT(found.standard_error, 0.3 * truth.sum);
  }
}

TEST(WaveSample, IsExactWhereTheMeasuresAgree) {
  const WaveSample sample = sample_waves(lives(1), n_lives, 40);
  std::vector<DearSlip> same;
  for (const SampledWave& one : sample.waves) same.push_back({3. * one.block, 0., ""});
  const DearSum found = estimate(sample, same);
  EXPECT_NEAR(found.sum, 3. * sample.block, 1e-9 * sample.block);
  EXPECT_NEAR(found.standard_error, 0., 1e-6 * sample.block);
}

TEST(WaveSample, MeetsWavesThatSlideNoBlock) {
  constexpr double cut = 1.8, highest = cut * 6.;
  double friction = 1.;
  while (formula_law(Law::exact, caisson_of(friction), storm(6.))->threshold() < highest) friction *= 1.01;
  LifeSetup cut_off = lives(2, friction);
  cut_off.uncertain = {};
  cut_off.cut = cut;
  const WaveSample all = sample_waves(cut_off, 50, everything), few = sample_waves(cut_off, 50, 20);
  EXPECT_EQ(all.block, 0.);
  ASSERT_FALSE(few.is_whole);
  const DearSum truth = estimate(all, dear(all, friction)), found = estimate(few, dear(few, friction));
  EXPECT_GT(truth.sum, 0.);
  EXPECT_GT(found.standard_error, 0.);
  EXPECT_LT(std::abs(found.sum - truth.sum), 3. * found.standard_error);
}

TEST(WaveSample, IsOfTheSameLives) {
  const LifeSimulation simulation(lives(3));
  std::vector<double> sliding;
  for (std::uint32_t i = 0; i < 400; ++i) sliding.push_back(simulation.life(i).sliding);
  const LifeStatistics s = statistics(sliding);
  const WaveSample sample = sample_waves(lives(3), 400, 10);
  EXPECT_NEAR(sample.block / 400., s.mean, 1e-9 * s.mean) << "with scatter from wave to wave the waves are the same";
  EXPECT_NEAR(sample.lives, s.standard_error / s.mean, 1e-9);
  LifeSetup without = lives(3);
  without.uncertain = {};
  const double quadrature =
      expected_distance(*formula_law(Law::exact, caisson_of(1.), storm(6.)), RayleighHeights(6.), 600.).distance +
      expected_distance(*formula_law(Law::exact, caisson_of(1.), storm(5.)), RayleighHeights(5.), 600.).distance;
  const WaveSample certain = sample_waves(without, 2000, 10);
  EXPECT_LT(std::abs(certain.block / 2000. - quadrature), 3. * certain.lives * quadrature);
}

TEST(WaveSample, GivesWavesWithoutAnswerTheLargestRatio) {
  const WaveSample sample = sample_waves(lives(4), n_lives, everything);
  std::vector<DearSlip> slips;
  for (const SampledWave& one : sample.waves) slips.push_back({2. * one.block, 0.1 * one.block, ""});
  const double whole = estimate(sample, slips).sum;
  EXPECT_NEAR(estimate(sample, slips).measure_error, 0.1 * sample.block, 1e-9 * sample.block);
  slips[0].why_not = "it diverges";
  const DearSum found = estimate(sample, slips);
  EXPECT_EQ(found.unanswered, 1);
  EXPECT_NEAR(found.sum, whole, 1e-9 * whole);
  for (DearSlip& slip : slips) slip.why_not = "it diverges";
  EXPECT_NE(estimate(sample, slips).why_not.find("as it diverges"), std::string::npos);
}

}  // namespace wave_sample_test

}  // namespace upbead::test
