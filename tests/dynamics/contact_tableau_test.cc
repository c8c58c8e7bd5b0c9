// Claims: the tableau for sliding nodes is of order 2, L-stable, and has positive weights and the same diagonal as that
// of order 4; its stability function is w^3 + w^2 - w with w = 1/(1 - z/4).
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>

#include "../../src/dynamics/dirk.h"

namespace contact_tableau_test {

using namespace upbead;
using Complex = std::complex<double>;

/// R(z) = 1 + z b'(I - z a)^-1 1 [Hairer and Wanner, Solving ODEs II, eq. (IV.3.3)].
Complex stability_function(const detail::Tableau& tableau, Complex z) {
  const Eigen::Index s = tableau.a.rows();
  const Eigen::MatrixXcd A = Eigen::MatrixXcd::Identity(s, s) - z * tableau.a.cast<Complex>();
  const Eigen::VectorXcd k = A.partialPivLu().solve(Eigen::VectorXcd::Ones(s));
  return 1. + z * (tableau.b().cast<Complex>().transpose() * k)(0);
}

TEST(FrictionTableau, IsOfOrderTwoWithPositiveWeights) {
  const detail::Tableau tableau = detail::friction_tableau();
  EXPECT_NEAR(tableau.b().sum(), 1., 1e-15);
  EXPECT_NEAR(tableau.b().dot(tableau.c()), 0.5, 1e-15);
  EXPECT_TRUE((tableau.b().array() > 0.).all());
  EXPECT_TRUE((tableau.a.diagonal().array() == detail::sdirk4_tableau().gamma()).all()) << "they share a matrix";
}

TEST(FrictionTableau, IsLStable) {
  const detail::Tableau tableau = detail::friction_tableau();
  for (double y = 1e-2; y < 1e4; y *= 1.05) EXPECT_LE(std::abs(stability_function(tableau, {0., y})), 1.) << y;
  EXPECT_LT(std::abs(stability_function(tableau, -1e12)), 1e-11);
  for (const Complex z : {Complex(0., 1.), Complex(-3., 2.), Complex(-0.1, 20.)}) {
    const Complex w = 1. / (1. - 0.25 * z);
    EXPECT_LT(std::abs(stability_function(tableau, z) - (w * w * w + w * w - w)), 1e-15);
  }
}

}  // namespace contact_tableau_test
