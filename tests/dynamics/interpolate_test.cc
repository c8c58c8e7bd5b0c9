// Claims: the quintic reproduces every polynomial of degree 5 with its derivatives, and its error falls with h^6.
// Tolerance: round-off of coefficients of order 1 (1e-12 after division by h^2 = 0.09).
#include "dynamics/interpolate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace interpolate_test {

using namespace upbead;

TEST(QuinticHermite, IsExactToDegreeFive) {
  for (int degree = 0; degree <= 5; ++degree) {
    const auto jet = [degree](double t) {
      return Jet{std::pow(t, degree), degree > 0 ? degree * std::pow(t, degree - 1) : 0.,
                 degree > 1 ? degree * (degree - 1) * std::pow(t, degree - 2) : 0.};
    };
    const QuinticHermite polynomial(0.7, 0.3, jet(0.7), jet(1.));
    for (double t : {0.7, 0.75, 0.8, 0.99, 1.}) {
      EXPECT_NEAR(polynomial(t).value, jet(t).value, 1e-14);
      EXPECT_NEAR(polynomial(t).first, jet(t).first, 1e-13);
      EXPECT_NEAR(polynomial(t).second, jet(t).second, 1e-12);
    }
  }
}

TEST(QuinticHermite, ErrorFallsWithTheSixthPower) {
  const auto jet = [](double t) { return Jet{std::sin(t), std::cos(t), -std::sin(t)}; };
  const auto error = [&](double h) {
    return std::abs(QuinticHermite(1., h, jet(1.), jet(1. + h))(1. + 0.5 * h).value - std::sin(1. + 0.5 * h));
  };
  EXPECT_NEAR(std::log2(error(0.4) / error(0.2)), 6., 0.2);
}

}  // namespace interpolate_test
