// Claim: for a history that is larger and later than a record, the comparison gives the factor and the delay.
#include "response/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace upbead {
namespace comparison_test {

struct Sampled : History {
  Sampled(double begin, double end, int n, const std::function<double(double)>& f) {
    for (int i = 0; i <= n; ++i) {
      time.push_back(begin + (end - begin) * i / n);
      value.push_back(f(time.back()));
    }
  }
};

double bump(double t) {
  return std::exp(-std::pow((t - 0.4) / 0.05, 2)) - 0.3 * std::exp(-std::pow((t - 0.6) / 0.08, 2));
}

Comparison of(const Sampled& measured, const Sampled& computed) {
  return compare(measured, computed);
}

TEST(Comparison, OfEqualHistoriesIsNothing) {
  const Sampled measured(0., 1., 5000, bump), computed(0., 1., 997, bump);
  const Comparison c = of(measured, computed);
  EXPECT_NEAR(c.peak_measured, 1., 1e-3);
  EXPECT_NEAR(c.peak_ratio, 1., 1e-3);
  EXPECT_LT(c.rms_relative, 1e-3);
  EXPECT_NEAR(c.phase, 0., 1e-5);
}

TEST(Comparison, TellsSizeAndPhase) {
  for (const double lag : {-0.03, 0.0172}) {
    const Sampled measured(-0.1, 0.9, 4000, [](double t) { return -2. * bump(t); });
    const Sampled computed(0., 1., 3000, [=](double t) { return -3. * bump(t - lag); });
    const Comparison c = of(measured, computed);
    EXPECT_NEAR(c.peak_measured, -2., 5e-3);
    EXPECT_NEAR(c.peak_computed, -3., 5e-3);
    EXPECT_NEAR(c.peak_ratio, 1.5, 5e-3);
    EXPECT_NEAR(c.phase, lag, 2e-4);
  }
}

TEST(Comparison, TellsTheRootMeanSquare) {
  const Sampled measured(0., 1., 1000, [](double t) { return std::sin(20. * M_PI * t); });
  const Sampled computed(0., 1., 1000, [](double t) { return 1.1 * std::sin(20. * M_PI * t); });
  EXPECT_NEAR(of(measured, computed).rms, 0.1 / std::sqrt(2.), 1e-4);
  EXPECT_NEAR(of(measured, computed).rms_relative, 0.1, 1e-6);
}

TEST(Comparison, NeedsSomethingInCommon) {
  const Sampled early(0., 1., 10, bump), late(2., 3., 10, bump), zero(0., 1., 10, [](double) { return 0.; });
  EXPECT_THROW(of(early, late), std::invalid_argument);
  EXPECT_THROW(of(zero, early), std::invalid_argument);
}

}  // namespace comparison_test
}  // namespace upbead
