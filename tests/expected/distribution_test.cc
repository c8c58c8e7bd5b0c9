// Claim: quantiles are those of the named distributions with the given mean and deviation; a cut removes the tails
// and scales up the rest.
#include "upbead/expected/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace upbead::test {

namespace distribution_test {

Scatter scatter(ScatterKind kind, double mean, double deviation) {
  Scatter s;
  s.kind = kind;
  s.mean = mean;
  s.deviation = deviation;
  return s;
}

/// Mean and standard deviation over equal parts of u.
std::array<double, 2> moments(const Distribution& distribution) {
  const int n = 400000;
  double sum = 0., squares = 0.;
  for (int i = 0; i < n; ++i) {
    const double x = distribution.quantile((i + 0.5) / n);
    sum += x;
    squares += x * x;
  }
  const double mean = sum / n;
  return {mean, std::sqrt(squares / n - mean * mean)};
}

std::string first_fault(const Scatter& s, double mean = 1.) {
  const std::vector<Diagnostic> list = diagnose(s, mean).list();
  return list.empty() ? "" : list.front().place.key + ": " + list.front().what;
}

TEST(Distribution, NormalAndLognormalHaveTheirMeanAndDeviation) {
  for (const ScatterKind kind : {ScatterKind::normal, ScatterKind::lognormal}) {
    const auto [mean, deviation] = moments({scatter(kind, 0.9, 0.2), 1.});
    EXPECT_NEAR(mean, 0.9, 1e-5);
    EXPECT_NEAR(deviation, 0.2, 1e-4);
  }
  EXPECT_NEAR(Distribution(scatter(ScatterKind::normal, 1., 0.1), 1.).quantile(0.975), 1. + 0.1 * 1.959963984540054,
              1e-12);
}

TEST(Distribution, CovIsDeviationOverMean) {
  Scatter s;
  s.mean = 0.5;
  s.cov = 0.1;
  EXPECT_NEAR(moments({s, 1.})[1], 0.05, 1e-5);
  s.mean.reset();
  EXPECT_NEAR(moments({s, 2.})[0], 2., 1e-5) << "the mean of where it is used";
}

TEST(Distribution, UniformAndTriangularHaveTheirEnds) {
  Scatter s;
  s.kind = ScatterKind::uniform;
  s.low = -1.;
  s.high = 3.;
  EXPECT_DOUBLE_EQ(Distribution(s, 1.).quantile(0.25), 0.);
  s.kind = ScatterKind::triangular;
  s.mode = 0.;
  const Distribution triangular(s, 1.);
  EXPECT_NEAR(triangular.quantile(0.25), 0., 1e-12) << "a quarter of the area lies below the mode";
  EXPECT_NEAR(triangular.quantile(1e-12), -1., 1e-5);
  EXPECT_NEAR(triangular.quantile(1. - 1e-12), 3., 1e-5);
}

TEST(Distribution, CutsLeaveOutAndScaleUp) {
  Scatter s = scatter(ScatterKind::normal, 1., 0.1);
  s.low = 0.9;
  s.high = 1.1;
  const Distribution cut(s, 1.);
  EXPECT_NEAR(cut.quantile(1e-15), 0.9, 1e-12);
  EXPECT_NEAR(cut.quantile(0.5), 1., 1e-12);
  EXPECT_GE(cut.quantile(1e-17), 0.9);
  EXPECT_LE(cut.quantile(1. - 1e-16), 1.1);
  EXPECT_NEAR(moments(cut)[1], 0.1 * std::sqrt(1. - 2. * 0.24197072451914337 / 0.6826894921370859), 1e-5)
      << "deviation of a normal distribution cut at one deviation: 1 - 2 phi(1)/(Phi(1) - Phi(-1))";
}

TEST(Distribution, NoDeviationIsOneValue) {
  for (const ScatterKind kind : {ScatterKind::normal, ScatterKind::lognormal})
    for (const double u : {1e-9, 0.5, 0.999}) EXPECT_EQ(Distribution(scatter(kind, 1., 0.), 1.).quantile(u), 1.);
}

TEST(Distribution, ContradictionsAreTold) {
  EXPECT_EQ(first_fault({}), "deviation: neither 'cov' nor 'deviation' is given");
  Scatter s = scatter(ScatterKind::normal, 0., 0.1);
  s.cov = 0.1;
  EXPECT_EQ(first_fault(s), "cov: both 'cov' and 'deviation' are given");
  s.deviation.reset();
  EXPECT_EQ(first_fault(s), "cov: 'cov' means nothing with a mean of 0");
  EXPECT_EQ(first_fault(scatter(ScatterKind::lognormal, -1., 0.1)),
            "mean: the mean of a lognormal distribution, -1, is not above 0");
  s = scatter(ScatterKind::normal, 1., 0.1);
  s.low = 3.;
  EXPECT_EQ(first_fault(s), "low: less than 1e-6 of the distribution is left between its cuts");
  s.kind = ScatterKind::uniform;
  EXPECT_EQ(first_fault(s), "high: 'high' is missing");
  s.high = 2.;
  EXPECT_EQ(first_fault(s), "low: low = 3 is not below high = 2");
  s.low = 1.;
  s.mode = 4.;
  s.kind = ScatterKind::triangular;
  EXPECT_EQ(first_fault(s), "mode: mode = 4 is not between low and high");
  EXPECT_THROW(Distribution(s, 1.), std::invalid_argument);
}

}  // namespace distribution_test
}  // namespace upbead::test
