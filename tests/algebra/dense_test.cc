// Claims: products by LAPACK and BLAS equal Eigen's, also for blocks of larger matrices; solutions satisfy their
// equations; a singular matrix gives NaN. Tolerance 1e-13: sums of 40 terms.
#include "algebra/dense.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "algebra/dense_factors.h"

namespace dense_test {

using namespace upbead;

Eigen::MatrixXd sample(Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [](Eigen::Index i, Eigen::Index j) {
    return std::sin(1. + 3. * static_cast<double>(i * i) + 7. * static_cast<double>(j));
  });
}

TEST(Dense, ProductsAreThoseOfEigen) {
  const Eigen::MatrixXd A = sample(60, 50), B = sample(70, 9);
  const auto part = A.topRows(40), right = B.middleRows(3, 50);
  const Eigen::MatrixXd expected = part * right, transposed = part.transpose() * B.topRows(40);
  EXPECT_LT((product(part, right) - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.norm());
  EXPECT_LT((transposed_product(part, B.topRows(40)) - transposed).cwiseAbs().maxCoeff(), 1e-13 * transposed.norm());
}

TEST(Dense, ProductsOfNothingAreZero) {
  EXPECT_EQ(product(Eigen::MatrixXd(3, 0), Eigen::MatrixXd(0, 2)), Eigen::MatrixXd::Zero(3, 2));
  EXPECT_EQ(transposed_product(Eigen::MatrixXd(4, 0), Eigen::MatrixXd(4, 2)).rows(), 0);
}

TEST(Dense, SolutionsGiveTheRightHandSideBack) {
  const Eigen::MatrixXd A = sample(40, 40) + 8. * Eigen::MatrixXd::Identity(40, 40), B = sample(40, 3);
  EXPECT_LT((A * solve_dense(A, B) - B).norm(), 1e-13 * B.norm());
}

TEST(Dense, ASingularMatrixGivesNoNumbers) {
  EXPECT_TRUE(std::isnan(solve_dense(Eigen::MatrixXd::Zero(3, 3), Eigen::MatrixXd::Ones(3, 1))(0, 0)));
}

TEST(Dense, FactorsSolveOftenAndTellNothingOfASingularMatrix) {
  const Eigen::MatrixXd A = sample(40, 40) + 8. * Eigen::MatrixXd::Identity(40, 40), B = sample(40, 3);
  DenseFactors factors;
  factors.compute(A);
  for (Eigen::Index j = 0; j < B.cols(); ++j)
    EXPECT_LT((A * factors.solve(B.col(j)) - B.col(j)).norm(), 1e-13 * B.norm());
  factors.compute(Eigen::MatrixXd::Zero(3, 3));
  EXPECT_FALSE(factors.solve(Eigen::VectorXd::Ones(3)).allFinite());
}

TEST(Dense, ASymmetricProductReadsTheLowerHalfAlone) {
  const Eigen::MatrixXd half = sample(40, 40).triangularView<Eigen::Lower>(), x = sample(40, 1);
  const Eigen::MatrixXd whole = half.selfadjointView<Eigen::Lower>();
  EXPECT_LT((symmetric_product(half, x.col(0)) - whole * x).norm(), 1e-13 * (whole * x).norm());
}

}  // namespace dense_test
