// One matrix, factorised by several processes that each hold a part of the matrix.

#include <gtest/gtest.h>

#include <set>

#include "../support/thread_processes.h"
#include "algebra/factorisation.h"
#include "quasi_definite.h"

namespace upbead {
namespace sharing_test {

using Eigen::MatrixXd;

/// A sum of `count` random matrices, each over unknowns of its own and over shared unknowns, which are spread among
/// its own.
class Shared : public testing::TestWithParam<int> {
 protected:
  static constexpr int n_own = 90, n_shared = 17, n_here = n_own + n_shared;

  Shared() : whole_(MatrixXd::Zero(count() * n_own + n_shared, count() * n_own + n_shared)) {
    for (int k = 0; k < n_shared; ++k) shared_.push_back(5 * k + 2);
    for (int rank = 0; rank < count(); ++rank) {
      parts_.push_back(test::random_quasi_definite(n_here, 3, 40u + static_cast<unsigned>(rank)));
      int own = 0, next = 0;
      std::vector<int> unknowns;
      for (int i = 0; i < n_here; ++i)
        unknowns.push_back(std::binary_search(shared_.begin(), shared_.end(), i) ? count() * n_own + next++
                                                                                 : rank * n_own + own++);
      whole_of_.push_back(unknowns);
      const MatrixXd part = parts_.back();
      for (int i = 0; i < n_here; ++i)
        for (int j = 0; j < n_here; ++j) whole_(unknowns[i], unknowns[j]) += part(i, j);
    }
  }
  int count() const { return GetParam(); }

  MatrixXd here(int rank, const MatrixXd& of_whole) const {
    MatrixXd values(n_here, of_whole.cols());
    for (int i = 0; i < n_here; ++i) values.row(i) = of_whole.row(whole_of_[rank][i]);
    return values;
  }

  MatrixXd whole_;
  std::vector<SparseMatrix> parts_;
  std::vector<int> shared_;
  std::vector<std::vector<int>> whole_of_;  ///< per process and unknown: its index in the whole
};

TEST_P(Shared, SolvesTheSumOfAllParts) {
  const MatrixXd B = MatrixXd::Random(whole_.rows(), 11), X = whole_.fullPivLu().solve(B);
  std::vector<MatrixXd> found(static_cast<std::size_t>(count()));
  test::on_processes(count(), [&](const std::shared_ptr<const Processes>& processes) {
    const int rank = processes->rank();
    MatrixXd b = here(rank, B);
    if (rank > 0)
      for (const int i : shared_) b.row(i).setZero();  // the first process has the whole right-hand side
    const Factorisation factors(parts_[rank], {}, {processes, shared_});
    found[rank] = factors.solve_columns(b);
    if (found[rank].col(3) != factors.solve(b.col(3))) found[rank].setZero();
  });
  for (int rank = 0; rank < count(); ++rank) {
    EXPECT_LT((found[rank] - here(rank, X)).cwiseAbs().maxCoeff(), 1e-12 * X.cwiseAbs().maxCoeff()) << rank;
    for (const int i : shared_) EXPECT_EQ(found[rank].row(i), found[0].row(i)) << rank;
  }
}

/// On every process, the pivots of shared unknowns are those of the whole matrix.
TEST_P(Shared, CountsTheNegativePivotsOfItsUnknowns) {
  std::vector<Inertia> inertia(static_cast<std::size_t>(count()));
  test::on_processes(count(), [&](const std::shared_ptr<const Processes>& processes) {
    inertia[processes->rank()] = Factorisation(parts_[processes->rank()], {}, {processes, shared_}).inertia();
  });
  for (const Inertia& found : inertia) {
    EXPECT_EQ(found.negative, n_here / 3);
    EXPECT_EQ(found.positive, n_here - n_here / 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Processes, Shared, testing::Values(2, 3, 4));

TEST(Sharing, RefusesBlocksWithSharedUnknowns) {
  const SparseMatrix A = test::random_quasi_definite(9, 2, 1);
  test::on_processes(1, [&](const std::shared_ptr<const Processes>& processes) {
    EXPECT_THROW(Factorisation(A, {{0, 1}}, {processes, {0, 4}}), std::invalid_argument);
  });
}

}  // namespace sharing_test
}  // namespace upbead
