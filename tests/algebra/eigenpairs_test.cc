// Claims: the eigenpairs of a matrix built from known real and complex pairs are found again; conjugate pairs stand
// side by side, the positive imaginary part first; vectors have length 1.
#include "algebra/eigenpairs.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

namespace eigenpairs_test {

using namespace upbead;
using Complex = std::complex<double>;

/// S B S^-1 with eigenvalues 2, -5, 1 +- 3i, -0.5 +- 40i; S is well conditioned and no orthogonal matrix.
Eigen::MatrixXd made_of_known_pairs() {
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(6, 6), S = Eigen::MatrixXd::Identity(6, 6);
  B(0, 0) = 2.;
  B(5, 5) = -5.;
  B.block(1, 1, 2, 2) << 1., 3., -3., 1.;
  B.block(3, 3, 2, 2) << -0.5, 400., -4., -0.5;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) S(i, j) += 0.3 * std::sin(1. + 7 * i + 3 * j);
  return S * B * S.inverse();
}

TEST(Eigenpairs, OfAKnownMatrix) {
  const Eigenpairs pairs = eigenpairs(made_of_known_pairs());
  const std::vector<Complex> expected{2., -5., {1., 3.}, {1., -3.}, {-0.5, 40.}, {-0.5, -40.}};
  ASSERT_EQ(pairs.value.size(), 6);
  for (const Complex value : expected)
    EXPECT_EQ(std::count_if(pairs.value.begin(), pairs.value.end(),
                            [&](Complex found) { return std::abs(found - value) < 1e-11; }),
              1)
        << value;
}

TEST(Eigenpairs, VectorsGiveTheMatrixBack) {
  const Eigen::MatrixXd A = made_of_known_pairs();
  const Eigenpairs pairs = eigenpairs(A);
  const Eigen::MatrixXcd difference = A * pairs.vector - pairs.vector * pairs.value.asDiagonal();
  EXPECT_LT(difference.norm(), 1e-13 * A.norm());
  EXPECT_LT((pairs.vector.colwise().norm().array() - 1.).abs().maxCoeff(), 1e-14);
  EXPECT_GT(std::abs(pairs.vector.determinant()), 1e-6) << "vectors of their own";
}

TEST(Eigenpairs, ConjugatesStandSideBySide) {
  const Eigenpairs pairs = eigenpairs(made_of_known_pairs());
  int n_pairs = 0;
  for (Eigen::Index j = 0; j < pairs.value.size(); ++j) {
    if (pairs.value[j].imag() == 0.) continue;
    EXPECT_GT(pairs.value[j].imag(), 0.);
    ASSERT_LT(j + 1, pairs.value.size());
    EXPECT_EQ(pairs.value[j + 1], std::conj(pairs.value[j]));
    EXPECT_EQ(pairs.vector.col(j + 1), pairs.vector.col(j).conjugate());
    ++n_pairs;
    ++j;
  }
  EXPECT_EQ(n_pairs, 2);
}

}  // namespace eigenpairs_test
