// Claims: products and positive solutions by wide registers are those of Eigen, for any number of rows; a matrix that
// is not positive definite is refused.

#include "waves/dense_products.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace upbead {
namespace dense_products_test {

/// Of zeros around A.
Eigen::MatrixXd with_padding(const Eigen::MatrixXd& A, Eigen::Index rows, Eigen::Index cols) {
  Eigen::MatrixXd padded_A = Eigen::MatrixXd::Zero(rows, cols);
  padded_A.topLeftCorner(A.rows(), A.cols()) = A;
  return padded_A;
}

TEST(DenseProducts, AreThoseOfEigen) {
  for (const Eigen::Index n : {1, 7, 8, 21, 53})
    for (const Eigen::Index at : {0, 3}) {
      const Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, 9);
      const Eigen::Index size = at + padded(n);
      Eigen::MatrixXd C = Eigen::MatrixXd::Ones(size, size);
      add_products(with_padding(A, padded(n), 9), at, C);
      const Eigen::MatrixXd wanted = Eigen::MatrixXd::Ones(n, n) + A * A.transpose();
      const Eigen::MatrixXd difference = C.block(at, at, n, n) - wanted;
      EXPECT_LT(Eigen::MatrixXd(difference.triangularView<Eigen::Lower>()).norm(), 1e-13 * wanted.norm()) << n;
    }
}

TEST(DenseProducts, SolveAsEigenDoes) {
  for (const Eigen::Index n : {1, 7, 15, 16, 17, 32, 44, 274}) {
    const Eigen::MatrixXd B = Eigen::MatrixXd::Random(n, n + 5);
    const Eigen::MatrixXd A = B * B.transpose();
    const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
    Eigen::MatrixXd both = with_padding(A, padded(n + 1), padded(n + 1));
    both.row(n).head(n) = b.transpose();
    const Eigen::VectorXd x = solve_positive(both, n);
    ASSERT_EQ(x.size(), n);
    EXPECT_LT((A * x + b).norm(), 1e-10 * b.norm()) << n;
    const Eigen::MatrixXd L = both.topLeftCorner(n, n).triangularView<Eigen::Lower>();
    EXPECT_LT((L * L.transpose() - A).norm(), 1e-13 * A.norm()) << n;
  }
}

TEST(DenseProducts, RefuseWhatIsNotPositive) {
  Eigen::MatrixXd A = with_padding(Eigen::MatrixXd::Identity(20, 20), 24, 24);
  A(18, 18) = -1.;
  EXPECT_EQ(solve_positive(A, 20).size(), 0);
}

}  // namespace dense_products_test
}  // namespace upbead
