// Claims: a system divided among processes marches like the whole system, with the same readings and energies; each
// process holds its own and the shared unknowns.
// Tolerance: 1e-11, some hundred steps of round-off.
#include <gtest/gtest.h>

#include "../support/thread_processes.h"
#include "sample_system.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace divided_test {

using namespace upbead;
using namespace upbead::test;

/// Copies of the sample system, joined at two u, one phi and the prescribed phi.
class Joined {
 public:
  explicit Joined(int count) : count_(count), sample_(sample_system({1., 1., 1., 0.1, false, true})) {}

  /// Index in the whole system of unknown i of one copy: the shared unknowns come first, then copy by copy.
  int index(int copy, int i) const {
    if (i == sample_.size() - 1) return n_shared + n_own * count_;
    for (int k = 0; k < n_shared; ++k)
      if (i == shared[k]) return k;
    return n_shared + n_own * copy + i -
           static_cast<int>(std::count_if(shared, shared + n_shared, [i](int s) { return s < i; }));
  }

  /// With the matrices of the copies from `begin` to `end`.
  System system(int begin, int end) const {
    System system;
    system.field.assign(static_cast<std::size_t>(n_shared + n_own * count_ + 1), Field::displacement);
    system.n_prescribed = 1;
    for (int copy = 0; copy < count_; ++copy) {
      for (int i = 0; i < sample_.size(); ++i) system.field[index(copy, i)] = sample_.field[i];
      for (const IndexRange& block : sample_.blocks)
        system.blocks.push_back({index(copy, block.begin), index(copy, block.begin) + block.size()});
    }
    for (SparseMatrix System::*matrix : {&System::M, &System::C, &System::K})
      system.*matrix = sum(sample_.*matrix, begin, end, system.size());
    system.radiation.resize(system.size(), system.size());
    system.loads = {sample_load(system, smooth()), prescribed_load(system, smooth())};
    const int last = count_ - 1;
    system.readings = {{"shared", "m", "", {{index(0, 0), 1.}}, {}, {}, {}},
                       {"own", "m", "", {{index(last, 4), 1.}}, {{index(0, 5), 2.}}, {}, {}},
                       {"a", "", "", {}, {}, {{index(last, 3), 1.}, {index(0, 1), 1.}}, {0.5, 0.25}}};
    return system;
  }

 private:
  SparseMatrix sum(const SparseMatrix& A, int begin, int end, int n) const {
    std::vector<Eigen::Triplet<double>> triplets;
    for (int copy = begin; copy < end; ++copy)
      for (int i = 0; i < A.rows(); ++i)
        for (SparseMatrix::InnerIterator it(A, i); it; ++it)
          triplets.emplace_back(index(copy, i), index(copy, static_cast<int>(it.col())),
                                (1. + 0.1 * copy) * it.value());
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
  }

  static constexpr int shared[] = {0, 1, 10}, n_shared = 3, n_own = 10;
  int count_;
  System sample_;
};

Response run(const System& system, SchemeKind kind) {
  const auto scheme = make_scheme(system, {kind});
  return march(system, *scheme, make_time_grid(kinks(system), 4., 0.1));
}

void expect_equal(const Response& found, const Response& whole) {
  const auto near = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-11 * b.cwiseAbs().maxCoeff());
  };
  near(found.ends.reading, whole.ends.reading);
  near(found.balanced.reading, whole.balanced.reading);
  ASSERT_EQ(found.energy.size(), whole.energy.size());
  const EnergyAccount &a = found.energy.back(), &b = whole.energy.back();
  for (const auto term : {&EnergyAccount::work, &EnergyAccount::kinetic, &EnergyAccount::strain, &EnergyAccount::fluid,
                          &EnergyAccount::drag, &EnergyAccount::damping, &EnergyAccount::scheme})
    EXPECT_NEAR(a.*term, b.*term, 1e-11 * b.largest_work);
  EXPECT_LT(a.mismatch(), 1e-12);
}

class Divided : public testing::TestWithParam<std::tuple<int, SchemeKind>> {};

TEST_P(Divided, MarchesAsTheWholeDoes) {
  const auto [count, kind] = GetParam();
  const Joined joined(count);
  const Response whole = run(joined.system(0, count), kind);
  std::vector<Response> found(static_cast<std::size_t>(count));
  std::vector<std::vector<int>> index(found.size());
  test::on_processes(count, [&, scheme = kind](const std::shared_ptr<const Processes>& processes) {
    const int rank = processes->rank();
    System part = joined.system(rank, rank + 1);
    index[rank] = divide(part, {}, processes);
    found[rank] = run(part, scheme);
  });
  for (int rank = 0; rank < count; ++rank) {
    expect_equal(found[rank], whole);
    EXPECT_EQ(found[rank].final_state.x.size(), 14);
    for (std::size_t i = 0; i < index[rank].size(); ++i) {
      if (index[rank][i] < 0) continue;
      const double x = found[rank].final_state.x[index[rank][i]];
      EXPECT_NEAR(x, whole.final_state.x[static_cast<Eigen::Index>(i)], 1e-11);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Processes, Divided,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha)));

TEST(Division, HoldsOwnAndSharedUnknownsInTheirOrder) {
  const Joined joined(3);
  test::on_processes(3, [&](const std::shared_ptr<const Processes>& processes) {
    const int rank = processes->rank();
    System part = joined.system(rank, rank + 1);
    const std::vector<int> index = divide(part, {joined.index(1, 2)}, processes);
    const int own = rank == 1 ? 0 : 1;  // the unknown that every process is asked to hold is additional elsewhere
    EXPECT_EQ(part.size(), 14 + own);
    EXPECT_EQ(part.n_prescribed, 1);
    EXPECT_EQ(part.loads[1].prescribed, part.size() - 1);
    EXPECT_EQ(part.blocks.size(), 2U);
    EXPECT_EQ(index[joined.index(rank, 6)], part.blocks[0].begin);
    EXPECT_EQ(part.sharing.unknowns, (std::vector<int>{0, 1, 2, index[joined.index(1, 2)]}));
    for (int other = 0; other < 3; ++other) EXPECT_EQ(index[joined.index(other, 4)] >= 0, other == rank);
  });
}

TEST(Division, NoticesSystemsOfDifferentSizes) {
  test::on_processes(2, [&](const std::shared_ptr<const Processes>& processes) {
    System part = Joined(2 + processes->rank()).system(0, 1);
    EXPECT_THROW(divide(part, {}, processes), NumericsError);
  });
}

TEST(Division, DoesNotStopEarly) {
  test::on_processes(1, [&](const std::shared_ptr<const Processes>& processes) {
    System part = Joined(1).system(0, 1);
    divide(part, {}, processes);
    const auto scheme = make_scheme(part);
    MarchOptions options;
    options.stop_at_energy = 0.1;
    EXPECT_THROW(march(part, *scheme, make_time_grid({}, 1., 0.1), options), std::invalid_argument);
  });
}

}  // namespace divided_test
