// Claims, on as many processes as mpirun starts: a matrix that is the sum of a part of each process is solved as the
// whole is, whichever shared unknowns a process holds, and with several right-hand sides and other values; every
// process knows the inertia of the whole; a matrix that is singular in one process's own unknowns, or in shared ones,
// is refused on all.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "algebra/factorisation.h"
#include "quasi_definite.h"
#include "upbead/base/error.h"

namespace sharing_test {

using namespace upbead;
using Eigen::MatrixXd;

int count(const std::shared_ptr<const Processes>& processes) {
  return processes ? processes->count() : 1;
}

/// A sum of random matrices, one of each process, over unknowns of its own and over some of the shared unknowns, which
/// are spread among its own. Of three processes and more, each lacks some shared unknowns. The whole has the shared
/// unknowns last.
class Shared : public testing::Test {
 protected:
  struct Part {
    SparseMatrix matrix;
    std::vector<int> whole;  ///< of each unknown, its index in the whole
    std::vector<int> shared, numbers;
  };

  Shared() {
    for (int rank = 0; rank < n_processes_; ++rank) parts_.push_back(part_of(rank));
    whole_ = whole(1.);
  }

  Part part_of(int rank) const {
    Part part;
    for (int number = 0; number < n_shared; ++number)
      if (n_processes_ > 1 && (n_processes_ == 2 || number % n_processes_ != rank)) part.numbers.push_back(number);
    // every third diagonal entry is negative: alike on all processes
    for (std::size_t k = 0; k < part.numbers.size(); ++k)
      part.shared.push_back(6 * static_cast<int>(k) + (part.numbers[k] % 3 == 2 ? 2 : 0));
    const int n = n_own + static_cast<int>(part.shared.size());
    part.matrix = test::random_quasi_definite(n, 3, 40U + static_cast<unsigned>(rank));
    int own = rank * n_own;
    auto number = part.numbers.begin();
    for (int i = 0; i < n; ++i)
      part.whole.push_back(
          std::binary_search(part.shared.begin(), part.shared.end(), i) ? n_processes_ * n_own + *number++ : own++);
    return part;
  }

  MatrixXd whole(double factor_of_last) const {
    const int n = n_processes_ * n_own + (n_processes_ > 1 ? n_shared : 0);
    MatrixXd sum = MatrixXd::Zero(n, n);
    for (const Part& part : parts_) {
      const MatrixXd dense = (&part == &parts_.back() ? factor_of_last : 1.) * MatrixXd(part.matrix);
      for (int i = 0; i < dense.rows(); ++i)
        for (int j = 0; j < dense.cols(); ++j) sum(part.whole[i], part.whole[j]) += dense(i, j);
    }
    return sum;
  }

  const Part& here() const { return parts_[processes_ ? processes_->rank() : 0]; }
  Sharing sharing() const {
    if (!processes_) return {};
    return {processes_, here().shared, here().numbers, n_shared};
  }
  MatrixXd here(const MatrixXd& of_whole) const {
    MatrixXd values(here().matrix.rows(), of_whole.cols());
    for (int i = 0; i < values.rows(); ++i) values.row(i) = of_whole.row(here().whole[i]);
    return values;
  }
  /// This process's part of a right-hand side: of a shared unknown, as many have it.
  MatrixXd part_of_sum(const MatrixXd& of_whole) const {
    MatrixXd values = here(of_whole);
    for (std::size_t k = 0; k < here().shared.size(); ++k)
      values.row(here().shared[k]) /= n_processes_ == 2 ? 2. : n_processes_ - 1.;
    return values;
  }
  void expect_solution(const MatrixXd& found, const MatrixXd& A, const MatrixXd& B) const {
    const MatrixXd X = A.fullPivLu().solve(B);
    EXPECT_LT((found - here(X)).cwiseAbs().maxCoeff(), 1e-12 * X.cwiseAbs().maxCoeff());
  }

  static constexpr int n_own = 90, n_shared = 17;
  std::shared_ptr<const Processes> processes_ = started_processes();
  int n_processes_ = count(processes_);
  std::vector<Part> parts_;
  MatrixXd whole_;
};

MatrixXd irregular(Eigen::Index n, int n_columns) {
  return MatrixXd::NullaryExpr(n, n_columns, [](Eigen::Index i, Eigen::Index j) { return std::sin(1. + 3. * i + j); });
}

TEST_F(Shared, SolvesTheSumOfAllParts) {
  const MatrixXd B = irregular(whole_.rows(), 11);
  const Factorisation factors(here().matrix, {}, sharing());
  const MatrixXd b = part_of_sum(B), found = factors.solve_columns(b);
  expect_solution(found, whole_, B);
  EXPECT_LT((found.col(3) - factors.solve(b.col(3))).cwiseAbs().maxCoeff(), 1e-13 * found.cwiseAbs().maxCoeff());
}

TEST_F(Shared, TakesOtherValuesOnTheSamePattern) {
  const MatrixXd B = irregular(whole_.rows(), 1);
  Factorisation factors(here().matrix, {}, sharing());
  const double factor = &here() == &parts_.back() ? 1.5 : 1.;
  factors.refactor(factor * here().matrix);
  expect_solution(factors.solve(part_of_sum(B)), whole(1.5), B);
}

TEST_F(Shared, KnowsTheInertiaOfTheWhole) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(whole_, Eigen::EigenvaluesOnly);
  const Inertia found = Factorisation(here().matrix, {}, sharing()).inertia();
  EXPECT_EQ(found.negative, (eigen.eigenvalues().array() < 0.).count());
  EXPECT_EQ(found.positive, (eigen.eigenvalues().array() > 0.).count());
}

TEST_F(Shared, KeepsSeveralMatricesAtOnce) {
  const MatrixXd B = irregular(whole_.rows(), 1);
  const Factorisation first(here().matrix, {}, sharing());
  {
    const Factorisation second(2. * here().matrix, {}, sharing());
    expect_solution(second.solve(part_of_sum(B)), 2. * whole_, B);
  }
  expect_solution(first.solve(part_of_sum(B)), whole_, B);
}

TEST_F(Shared, IsRefusedOnAllWhereOnePartIsSingular) {
  SparseMatrix matrix = here().matrix;
  if (&here() == &parts_.back()) {  // its own unknowns 1 and 3 move as one, and couple with nothing else
    matrix.prune([](Eigen::Index i, Eigen::Index j, double) { return i != 1 && j != 1 && i != 3 && j != 3; });
    for (const int i : {1, 3})
      for (const int j : {1, 3}) matrix.coeffRef(i, j) = 1.;
    matrix.makeCompressed();
  }
  EXPECT_THROW(Factorisation(matrix, {}, sharing()), NumericsError);
  matrix = here().matrix;
  if (&here() == &parts_.back()) matrix.coeffRef(3, 3) = std::nan("");
  EXPECT_THROW(Factorisation(matrix, {}, sharing()), NumericsError);
}

/// A chain of springs, some on each process, whose ends are shared with the neighbours.
struct Chain {
  explicit Chain(const std::shared_ptr<const Processes>& processes) : rank(processes ? processes->rank() : 0) {
    const int last = count(processes) - 1;
    sharing.processes = processes;
    sharing.n_all = last;
    for (const auto& [unknown, number] : {std::pair(0, rank - 1), std::pair(n - 1, rank)})
      if (number >= 0 && number < last) {
        sharing.unknowns.push_back(unknown);
        sharing.numbers.push_back(number);
      }
  }

  /// Held at its first end by a spring of such stiffness.
  SparseMatrix matrix(double stiffness) const {
    std::vector<Eigen::Triplet<double>> entries{{0, 0, rank == 0 ? stiffness : 0.}};
    for (int i = 0; i + 1 < n; ++i)
      for (const auto& [row, column, value] :
           {std::tuple(i, i, 1.), {i + 1, i + 1, 1.}, {i, i + 1, -1.}, {i + 1, i, -1.}})
        entries.emplace_back(row, column, value);
    SparseMatrix A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }

  static constexpr int n = 8;
  int rank;
  Sharing sharing;
};

TEST(Sharing, RefusesWhatIsSingularInSharedUnknownsAlone) {
  const auto processes = started_processes();
  const Chain chain(processes);
  Factorisation factors(chain.matrix(1.), {}, chain.sharing);
  EXPECT_EQ(factors.inertia().negative, 0);
  EXPECT_EQ(factors.inertia().positive, 7 * count(processes) + 1);
  EXPECT_THROW(Factorisation(chain.matrix(0.), {}, chain.sharing), NumericsError);
  EXPECT_THROW(factors.refactor(chain.matrix(0.)), NumericsError);
  factors.refactor(chain.matrix(0.5));
  Vector b = Vector::Zero(Chain::n);
  if (chain.rank == 0) b[0] = 1.;
  EXPECT_LT((factors.solve(b).array() - 2.).abs().maxCoeff(), 1e-12);  // all move alike, by force over stiffness
}

TEST(Sharing, KnowsTheInertiaWhereEveryUnknownIsShared) {
  constexpr int n = 600;
  Sharing sharing{started_processes(), {}, {}, 0};
  if (sharing.processes) {
    sharing.n_all = n;
    for (int i = 0; i < n; ++i) sharing.unknowns.push_back(i);
    sharing.numbers = sharing.unknowns;
  }
  const Factorisation factors(test::random_quasi_definite(n, n, 3), {}, sharing);
  EXPECT_EQ(factors.inertia().negative, n / 3);
  EXPECT_EQ(factors.inertia().positive, n - n / 3);
}

TEST(Sharing, LetsAProcessHoldNothing) {
  const auto processes = started_processes();
  if (count(processes) < 3) return;
  const bool empty = processes->rank() == 1;
  const int n = empty ? 0 : 2;
  SparseMatrix A(n, n);
  if (!empty) {
    const MatrixXd dense = (MatrixXd(2, 2) << 2., 1., 1., 2.).finished();
    A = dense.sparseView();
  }
  const Factorisation factors(A, {}, empty ? Sharing{processes, {}, {}, 1} : Sharing{processes, {1}, {0}, 1});
  EXPECT_EQ(factors.inertia().positive, count(processes));  // one of each of the others, and the shared one
  const Vector x = factors.solve(Vector::Ones(n));
  EXPECT_LT((x.array() - 1. / 3.).abs().sum(), 1e-15);
}

TEST(Sharing, RefusesBlocksWithSharedUnknowns) {
  const SparseMatrix A = test::random_quasi_definite(9, 2, 1);
  EXPECT_THROW(Factorisation(A, {{0, 1}}, {nullptr, {0, 4}, {0, 1}, 2}), std::invalid_argument);
}

}  // namespace sharing_test
