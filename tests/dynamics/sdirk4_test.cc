// Claims: the tableau is of order 4, stiffly accurate and L-stable.
// Source: Hairer & Wanner, Solving ODEs II, table IV.6.5; order conditions: Hairer, Noersett & Wanner, Solving ODEs I,
// table II.2.1. Tolerance 1e-14: a few roundings of coefficients of order 10.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "../../src/dynamics/dirk.h"

namespace sdirk4_test {

using namespace upbead;

TEST(Sdirk4, OrderConditions) {
  const detail::Tableau tableau = detail::sdirk4_tableau();
  const Eigen::MatrixXd& a = tableau.a;
  const Vector b = tableau.b(), c = tableau.c(), one = Vector::Ones(5);
  const Vector expected_c = (Vector(5) << 1. / 4., 3. / 4., 11. / 20., 1. / 2., 1.).finished();
  EXPECT_LT((c - expected_c).norm(), 1e-14);
  const Vector c2 = c.cwiseProduct(c), c3 = c2.cwiseProduct(c);
  EXPECT_NEAR(b.dot(one), 1., 1e-14);
  EXPECT_NEAR(b.dot(c), 1. / 2., 1e-14);
  EXPECT_NEAR(b.dot(c2), 1. / 3., 1e-14);
  EXPECT_NEAR(b.dot(a * c), 1. / 6., 1e-14);
  EXPECT_NEAR(b.dot(c3), 1. / 4., 1e-14);
  EXPECT_NEAR(b.cwiseProduct(c).dot(a * c), 1. / 8., 1e-14);
  EXPECT_NEAR(b.dot(a * c2), 1. / 12., 1e-14);
  EXPECT_NEAR(b.dot(a * (a * c)), 1. / 24., 1e-14);
}

TEST(Sdirk4, LStable) {
  const detail::Tableau tableau = detail::sdirk4_tableau();
  const Vector one = Vector::Ones(5);
  // R(z) = 1 + z b'(I - z a)^-1 1, so R(inf) = 1 - b' a^-1 1.
  EXPECT_NEAR(1. - tableau.b().dot(tableau.a.partialPivLu().solve(one)), 0., 1e-13);
  // A-stable: |R| <= 1 on the imaginary axis (all poles are at 1/gamma > 0).
  for (double y = 1e-2; y < 1e4; y *= 1.05) {
    const std::complex<double> z(0., y);
    const Eigen::MatrixXcd I = Eigen::MatrixXcd::Identity(5, 5);
    const Eigen::VectorXcd k =
        (I - z * tableau.a.cast<std::complex<double>>()).partialPivLu().solve(one.cast<std::complex<double>>());
    EXPECT_LE(std::abs(1. + z * (tableau.b().cast<std::complex<double>>().transpose() * k)(0)), 1. + 1e-12) << y;
  }
}

TEST(Sdirk4, EverythingOnTheDiagonalIsOneQuarter) {
  const Eigen::MatrixXd a = detail::sdirk4_tableau().a;
  EXPECT_TRUE((a.diagonal().array() == 0.25).all());
  EXPECT_TRUE(a.isLowerTriangular());
}

}  // namespace sdirk4_test
