// Claims: the sparse factorisation by supernodes has the solutions of a dense one, for patterns from diagonal to
// full; its inertia is that of the eigenvalues; each of several right-hand sides has, to the last bit, the solution
// that it has alone, and so has every repetition; both instruction sets agree to round-off; a singular matrix is
// refused in whichever supernode it is singular.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "../../src/algebra/ldlt/factor_view.h"
#include "../../src/algebra/ldlt/triangular_solve.h"
#include "algebra/factorisation.h"
#include "quasi_definite.h"
#include "upbead/base/error.h"

namespace supernodal_test {

using namespace upbead;
using Eigen::MatrixXd;

MatrixXd right_hand_sides(Eigen::Index n, int n_columns) {
  return MatrixXd::NullaryExpr(n, n_columns, [](Eigen::Index i, Eigen::Index j) { return std::sin(1. + 3. * i + j); });
}

struct Pattern {
  int n, per_row;
};

class Supernodal : public testing::TestWithParam<Pattern> {
 protected:
  SparseMatrix A_ = test::random_quasi_definite(GetParam().n, GetParam().per_row, 11);
};

INSTANTIATE_TEST_SUITE_P(Patterns, Supernodal,
                         testing::Values(Pattern{1, 0}, Pattern{9, 0}, Pattern{40, 1}, Pattern{300, 1}, Pattern{300, 2},
                                         Pattern{400, 6}, Pattern{150, 150}));

TEST_P(Supernodal, EqualsADenseSolution) {
  const MatrixXd B = right_hand_sides(A_.rows(), 1), expected = MatrixXd(A_).partialPivLu().solve(B);
  const Factorisation factors(A_);
  EXPECT_LT((factors.solve(B.col(0)) - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
}

TEST_P(Supernodal, InertiaIsThatOfTheEigenvalues) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(A_), Eigen::EigenvaluesOnly);
  const Inertia inertia = Factorisation(A_).inertia();
  EXPECT_EQ(inertia.negative, (eigen.eigenvalues().array() < 0.).count());
  EXPECT_EQ(inertia.positive, (eigen.eigenvalues().array() > 0.).count());
}

TEST_P(Supernodal, ColumnsEqualSingleSolutions) {
  const Factorisation factors(A_), again(A_);
  for (const int n_columns : {1, 3, 8, 19}) {
    const MatrixXd B = right_hand_sides(A_.rows(), n_columns), X = factors.solve_columns(B);
    for (int c = 0; c < n_columns; ++c) {
      EXPECT_EQ(X.col(c), factors.solve(B.col(c))) << c;
      EXPECT_EQ(X.col(c), again.solve(B.col(c))) << c;
    }
  }
}

TEST_P(Supernodal, InstructionSetsAgree) {
  const detail::Supernodes nodes = detail::find_supernodes(A_);
  detail::Factor factor = detail::make_factor(nodes);
  detail::factorise(nodes, detail::find_panel_entries(A_, nodes), A_.valuePtr(), factor);
  const MatrixXd B = right_hand_sides(A_.rows(), 2);
  MatrixXd baseline = B, chosen = B;
  std::vector<double> work(2 * static_cast<std::size_t>(detail::triangular_solve_work(nodes)));
  const detail::FactorView view = detail::view(nodes, factor);
  const double* end = detail::forward_baseline(view, baseline.data(), 2, work.data());
  detail::backward_baseline(view, end, baseline.data(), 2, work.data());
  end = detail::forward_half(view, chosen.data(), 2, work.data());
  detail::backward_half(view, end, chosen.data(), 2, work.data());
  EXPECT_LT((baseline - chosen).cwiseAbs().maxCoeff(), 1e-13 * baseline.cwiseAbs().maxCoeff());
}

TEST(SupernodalFactorisation, RefusesTwoEqualRows) {
  for (const int twin : {1, 150, 298}) {
    const SparseMatrix A = test::random_quasi_definite(299, 2, 13);
    MatrixXd dense = MatrixXd::Zero(300, 300);
    dense.topLeftCorner(299, 299) = MatrixXd(A);
    dense.row(299) = dense.row(twin);
    dense.col(299) = dense.col(twin);
    dense(299, 299) = dense(twin, twin);
    EXPECT_THROW(Factorisation{SparseMatrix(dense.sparseView())}, NumericsError);
  }
}

TEST(SupernodalFactorisation, NothingIsLeftAfterTheBlocks) {
  MatrixXd dense(2, 2);
  dense << 4., 1., 1., 3.;
  const Factorisation factors(SparseMatrix(dense.sparseView()), {{0, 2}});
  const Vector b = Vector::LinSpaced(2, 1., 2.);
  EXPECT_LT((dense * factors.solve(b) - b).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(factors.inertia().positive, 2);
}

// An entry below round-off may be missing in one triangle, as when assembly drops entries that cancel to zero.
TEST(SupernodalFactorisation, ReadsTheLowerTriangle) {
  SparseMatrix A = test::random_quasi_definite(60, 2, 17), one_sided = A;
  one_sided.coeffRef(3, 50) += 1e-18;  // above the diagonal only
  one_sided.makeCompressed();
  const Vector b = right_hand_sides(60, 1);
  EXPECT_EQ(Factorisation(one_sided).solve(b), Factorisation(A).solve(b));
}

}  // namespace supernodal_test
