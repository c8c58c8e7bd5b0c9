// Claim: the fit of k(alpha*) recovers known a and b, its confidence ellipse contains them as often as stated, and
// points that do not determine a and b are reported.
#include "expected/k_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace upbead::test {

namespace k_fit_test {

using Points = std::vector<DurationPoint>;

Points points_of(const DurationFactor& factor, int n = 60, double low = 0.01, double high = 2.) {
  Points points;
  for (int i = 0; i < n; ++i) {
    const double alpha_star = low + (high - low) * i / (n - 1);
    points.push_back({alpha_star, factor(alpha_star)});
  }
  return points;
}

Points with_noise(Points points, double deviation, std::mt19937& generator) {
  std::normal_distribution<double> noise(0., deviation);
  for (DurationPoint& point : points) point.k += noise(generator);
  return points;
}

TEST(DurationFit, FindsPlantedParameters) {
  for (const DurationFactor& planted : {DurationFactor{0.3, 2.}, {0.8, 0.5}, {1.7, 3.}, {0.1, 4.}, {3., 0.2}}) {
    const auto fit = fit_duration_factor(points_of(planted));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->best.a, planted.a, 1e-6 * planted.a);
    EXPECT_NEAR(fit->best.b, planted.b, 1e-6 * planted.b);
    EXPECT_EQ(fit->doubt, FitDoubt::none);
    EXPECT_NEAR(fit->quality.r_squared, 1., 1e-10);
  }
}

TEST(DurationFit, ItsEllipseHoldsThePlantedOnesInNinetyFivePercent) {
  std::mt19937 generator(7);
  const DurationFactor planted{0.3, 2.};
  const Points exact = points_of(planted);
  int held = 0, half = 0;
  for (int sample = 0; sample < 400; ++sample) {
    const auto fit = fit_duration_factor(with_noise(exact, 0.01, generator));
    ASSERT_TRUE(fit);
    held += in_ellipse(*fit, planted) ? 1 : 0;
    half += in_ellipse(*fit, planted, 0.5) ? 1 : 0;
  }
  EXPECT_NEAR(held / 400., 0.95, 0.033) << "three standard deviations of 400 draws";
  EXPECT_NEAR(half / 400., 0.50, 0.075);
}

TEST(DurationFit, ItsStandardErrorsAreTheScatterOfRepeatedSamples) {
  std::mt19937 generator(11);
  const DurationFactor planted{0.5, 1.5};
  const Points exact = points_of(planted);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero(), told = Eigen::Matrix2d::Zero();
  for (int sample = 0; sample < 500; ++sample) {
    const auto fit = fit_duration_factor(with_noise(exact, 0.005, generator));
    const Eigen::Vector2d away(fit->best.a - planted.a, fit->best.b - planted.b);
    scatter += away * away.transpose() / 500.;
    told += fit->covariance / 500.;
  }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(scatter(i, j) / told(i, j), 1., 0.2);
}

TEST(DurationFit, IsTheLeastOfTheSumOfSquares) {
  std::mt19937 generator(3);
  const Points points = with_noise(points_of({0.4, 1.}), 0.05, generator);
  const auto fit = fit_duration_factor(points);
  const double least = quality(points, fit->best).deviation;
  EXPECT_EQ(fit->quality.deviation, least);
  EXPECT_NEAR(fit->residual_deviation, least * std::sqrt(60. / 58.), 1e-12);
  for (const double step : {-1e-3, 1e-3}) {
    EXPECT_GT(quality(points, {fit->best.a + step, fit->best.b}).deviation, least);
    EXPECT_GT(quality(points, {fit->best.a, fit->best.b + step}).deviation, least);
  }
}

TEST(DurationFit, TellsWherePointsSayNothing) {
  EXPECT_FALSE(fit_duration_factor({{0.1, 0.5}, {0.2, 0.4}, {0.3, 0.3}})) << "too few";
  EXPECT_FALSE(fit_duration_factor(Points(9, {0.4, 0.3}))) << "one alpha*";

  Points above = points_of({0.3, 0.});  // k = 1 everywhere
  EXPECT_EQ(fit_duration_factor(above)->doubt, FitDoubt::edge);
  Points rising;
  for (int i = 1; i < 20; ++i) rising.push_back({0.1 * i, 0.2 + 0.02 * i});
  EXPECT_EQ(fit_duration_factor(rising)->doubt, FitDoubt::edge) << "no a > 0 makes k grow";

  // Points near a single alpha* determine only the product of both.
  const auto narrow = fit_duration_factor(points_of({0.8, 1.}, 20, 0.3, 0.30001));
  EXPECT_EQ(narrow->doubt, FitDoubt::ill_conditioned);
  EXPECT_FALSE(in_ellipse(*narrow, narrow->best));

  std::mt19937 generator(5);
  const auto noisy = fit_duration_factor(with_noise(points_of({0.8, 1.}, 20, 0.3, 0.6), 0.05, generator));
  EXPECT_EQ(noisy->doubt, FitDoubt::reaches_zero);
}

TEST(DurationFit, RefusesWhatIsNoNumber) {
  Points points = points_of({0.3, 2.});
  points[3].k = std::nan("");
  EXPECT_THROW(fit_duration_factor(points), std::invalid_argument);
  points[3] = {-0.1, 0.5};
  EXPECT_THROW(fit_duration_factor(points), std::invalid_argument);
}

TEST(DurationFit, QualityTellsBiasAndSpread) {
  const Points points{{0., 0.9}, {1., 0.35}};  // the paper's k: 1 and 0.25
  const FitQuality found = quality(points, {0.3, 2.});
  EXPECT_NEAR(found.bias, 0., 1e-15);
  EXPECT_NEAR(found.deviation, 0.1, 1e-15);
  EXPECT_NEAR(found.r_squared, 1. - 0.02 / (2 * 0.275 * 0.275), 1e-12);
}

}  // namespace k_fit_test
}  // namespace upbead::test
