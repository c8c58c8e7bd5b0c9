// Claims: the Laplace transform of straight pieces is exact; a full Krylov space has the response of the System
// itself at a complex frequency. Sources: closed forms. Tolerances: round-off.
#include "dynamics/frequency_response.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "dynamics/projection.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {
namespace frequency_response_test {

using Complex = std::complex<double>;

TEST(LaplaceTransform, OfATriangle) {
  // (1 - 2 e^(-s r) + e^(-2 s r)) / (r s^2), of a triangle of height 1 and rise r.
  const double r = 0.3;
  const Complex s(2., 7.);
  const SampledLoads loads = sample({piecewise_linear({0., r, 2. * r}, {0., 1., 0.})}, {0., 0.1, r, 0.5, 2. * r, 1.});
  const Complex exact = (1. - 2. * std::exp(-s * r) + std::exp(-2. * s * r)) / (r * s * s);
  EXPECT_LE(std::abs(laplace_transform(loads, s)[0] - exact), 1e-14);
}

TEST(LaplaceTransform, OfAJump) {
  const Complex s(1., 3.);
  SampledLoads loads;
  loads.time = {0., 1., 2.};
  loads.begin.resize(1, 2);
  loads.end.resize(1, 2);
  loads.begin << 1., 3.;
  loads.end << 1., 3.;
  const Complex exact = (1. - std::exp(-s)) / s + 3. * std::exp(-s) * (1. - std::exp(-s)) / s;
  EXPECT_LE(std::abs(laplace_transform(loads, s)[0] - exact), 1e-14);
}

SparseMatrix sparse(const Eigen::MatrixXd& A) {
  return A.sparseView();
}

/// Three displacements and one phi.
System small_system() {
  System system;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(4, 4), C = M, K = M;
  M.diagonal() << 1., 2., 1.5, -0.01;
  K << 4., -1., 0., 0., -1., 5., -2., 0., 0., -2., 3., 0., 0., 0., 0., 0.;
  C << 0.1, 0., 0., -0.3, 0., 0.2, 0., 0.1, 0., 0., 0.3, -0.2, -0.3, 0.1, -0.2, -0.05;
  system.M = sparse(M);
  system.C = sparse(C);
  system.K = sparse(K);
  system.field = {Field::displacement, Field::displacement, Field::displacement, Field::pressure_impulse};
  SystemLoad load;
  load.name = "force";
  load.vector = Vector::Zero(4);
  load.vector << 1., 0., 0.5, 0.;
  system.loads = {load};
  return system;
}

TEST(FrequencyResponse, OfAFullSpaceIsThatOfTheSystem) {
  const PetscSession session;
  const System system = small_system();
  SecondOrderKrylov krylov(system, 2.);
  while (krylov.extend()) continue;
  const Projection projection(system, krylov);
  const Complex s(0.5, 3.);
  const Eigen::VectorXcd F = Eigen::VectorXcd::Constant(1, Complex(2., -1.));
  const Eigen::MatrixXcd A =
      (s * s * Eigen::MatrixXd(system.M) + s * Eigen::MatrixXd(system.C)) + Eigen::MatrixXd(system.K);
  const Eigen::VectorXcd exact =
      A.partialPivLu().solve(Eigen::VectorXcd(F[0] * system.loads[0].vector.cast<Complex>()));
  const Eigen::VectorXcd X = frequency_response(krylov, projection.reduced(), s, F);
  EXPECT_LE((X - exact).norm(), 1e-12 * exact.norm());
}

}  // namespace frequency_response_test
}  // namespace upbead::test
