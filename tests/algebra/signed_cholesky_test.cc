// Claims: the product of the dense signed Cholesky factors is the matrix, for one block, for several blocks, and with
// rows below; the signs are those of the pivots; the remainder is the Schur complement; a zero pivot or one that is
// not finite is reported with its column; factorisations in several threads at once do not disturb each other.
// Source: Vanderbei, Symmetric quasi-definite matrices, SIAM J. Optim. 5 (1995) 100. Tolerance: 1e-13 of the largest
// entry, 450 units of round-off.
#include "../../src/algebra/ldlt/signed_cholesky.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "quasi_definite.h"

namespace signed_cholesky_test {

using namespace upbead;
using Eigen::MatrixXd;

struct Factorised {
  MatrixXd L;  ///< height x width, zero above the diagonal
  Eigen::VectorXd J;
  MatrixXd left;  ///< Schur complement, its lower triangle
  int stopped = 0;
};

Factorised factorised(const MatrixXd& A, int width) {
  const auto n = static_cast<int>(A.rows());
  Factorised f{A.leftCols(width), Eigen::VectorXd(width), A.bottomRightCorner(n - width, n - width)};
  std::vector<int> sign(static_cast<std::size_t>(width), 0);
  std::vector<double> work;
  const detail::Panel panel{f.L.data(), n, width};
  f.stopped = detail::factorise(panel, sign.data(), work);
  if (f.stopped < width) return f;
  detail::subtract_outer_product(panel, sign.data(), f.left.data(), work);
  f.L.topRows(width) = MatrixXd(f.L.topRows(width).triangularView<Eigen::Lower>());
  for (int j = 0; j < width; ++j) f.J[j] = sign[j];
  return f;
}

struct Shape {
  int height, width;
};

class SignedCholesky : public testing::TestWithParam<Shape> {};

// A block has 24 columns and a product 64, so these lie below, at and beyond both.
INSTANTIATE_TEST_SUITE_P(Shapes, SignedCholesky,
                         testing::Values(Shape{1, 1}, Shape{7, 3}, Shape{24, 24}, Shape{25, 24}, Shape{60, 25},
                                         Shape{130, 129}, Shape{200, 120}));

TEST_P(SignedCholesky, GivesTheMatrixBack) {
  const auto [n, width] = GetParam();
  const MatrixXd A(test::random_quasi_definite(n, n, 3));
  const Factorised f = factorised(A, width);
  ASSERT_EQ(f.stopped, width);
  MatrixXd rest = A - f.L * f.J.asDiagonal() * f.L.transpose();
  EXPECT_LT(rest.leftCols(width).cwiseAbs().maxCoeff(), 1e-13);
  rest.bottomRightCorner(n - width, n - width) -= f.left;
  EXPECT_TRUE(MatrixXd(rest.triangularView<Eigen::Lower>()).isZero(1e-13)) << "the Schur complement";
  for (int j = 0; j < width; ++j) EXPECT_EQ(f.J[j], j % 3 == 2 ? -1. : 1.) << j;
}

TEST(SignedCholesky, ThreadsDoNotDisturbEachOther) {
  const MatrixXd A(test::random_quasi_definite(200, 200, 3));
  const Factorised alone = factorised(A, 120);
  std::vector<int> n_wrong(4, 0);
  std::vector<std::thread> threads;
  for (int& wrong : n_wrong)
    threads.emplace_back([&] {
      for (int k = 0; k < 100; ++k) {
        const Factorised here = factorised(A, 120);
        if (here.L != alone.L || here.left != alone.left) ++wrong;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(n_wrong, std::vector<int>(4, 0)) << "wrong factors of 100 in each thread";
}

TEST(SignedCholesky, ReportsAZeroPivot) {
  for (const int zero : {0, 10, 30, 99}) {
    MatrixXd A(test::random_quasi_definite(100, 100, 5));
    A.row(zero) = zero == 0 ? MatrixXd::Zero(1, 100) : MatrixXd(A.row(zero / 2));
    A.col(zero) = A.row(zero).transpose();
    if (zero > 0) A(zero, zero) = A(zero / 2, zero / 2);  // two equal rows and columns
    EXPECT_EQ(factorised(A, 100).stopped, zero);
  }
}

TEST(SignedCholesky, ReportsANumberThatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    MatrixXd A(test::random_quasi_definite(50, 50, 5));
    A(40, 40) = bad;
    EXPECT_EQ(factorised(A, 50).stopped, 40);
  }
}

}  // namespace signed_cholesky_test
