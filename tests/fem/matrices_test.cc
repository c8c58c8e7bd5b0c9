// Claim: M, C and K are symmetric, and with the rows of phi multiplied by -1 they are M >= 0, sym(C) >= 0, K >= 0
// (the balance of energy requires that). Source: docs/theory.md. Tolerance: round-off of sums of a few hundred terms,
// relative to the largest entry.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "scenes.h"

namespace upbead::test {
namespace matrices_test {

constexpr double round_off = 1e-13;

Eigen::MatrixXd with_sign(const System& system, const SparseMatrix& matrix) {
  Eigen::MatrixXd dense(matrix);
  for (int i = 0; i < system.size(); ++i)
    if (system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse) dense.row(i) *= -1.;
  return dense;
}

/// Least eigenvalue of the symmetric part after scaling to a unit diagonal.
double least_eigenvalue(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd symmetric = 0.5 * (matrix + matrix.transpose());
  Eigen::VectorXd scale = symmetric.diagonal().cwiseAbs();
  for (double& s : scale) s = s > 0. ? 1. / std::sqrt(s) : 1.;
  symmetric = scale.asDiagonal() * symmetric * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

class Matrices : public ::testing::TestWithParam<Flow> {};

TEST_P(Matrices, AreSymmetric) {
  Scene scene = breakwater(triangle(1., 0.1));
  scene.regions["mound"].flow = GetParam();
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh);
  for (const SparseMatrix* matrix : {&compiled.system.M, &compiled.system.C, &compiled.system.K}) {
    const SparseMatrix difference = *matrix - SparseMatrix(matrix->transpose());
    EXPECT_LE(difference.coeffs().cwiseAbs().maxCoeff(), round_off * matrix->coeffs().cwiseAbs().maxCoeff());
  }
}

TEST_P(Matrices, HaveTheSignsOfTheEnergyLaw) {
  Region soil = rubble();
  soil.flow = GetParam();
  const auto mesh = column_mesh(5., 8);
  const Compiled compiled(column(soil, triangle(1., 0.1)), *mesh);
  const System& system = compiled.system;
  EXPECT_GE(least_eigenvalue(with_sign(system, system.M)), -round_off);
  EXPECT_GE(least_eigenvalue(with_sign(system, system.C)), -round_off);
  EXPECT_GE(least_eigenvalue(with_sign(system, system.K)), -round_off);
}

INSTANTIATE_TEST_SUITE_P(Flows, Matrices, ::testing::Values(Flow::darcy, Flow::inertial, Flow::drained));

}  // namespace matrices_test
}  // namespace upbead::test
