// Claims, on as many processes as mpirun starts: a system divided among them marches like the whole system, with the
// same readings and energies; each process holds its own unknowns and those that it shares. Tolerance: 1e-11, some
// hundred steps of round-off.
#include <gtest/gtest.h>

#include "sample_system.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace divided_test {

using namespace upbead;
using namespace upbead::test;

/// Copies of the sample system, joined at two u, one phi and the prescribed phi; the last of three copies and more has
/// the second u for itself.
class Joined {
 public:
  explicit Joined(int count)
      : count_(count), n_own_u_(count > 2 ? 1 : 0), sample_(sample_system({1., 1., 1., 0.1, false, true})) {}

  int size() const { return n_shared + n_own * count_ + n_own_u_ + 1; }
  /// Index in the whole system of unknown i of one copy: the shared unknowns come first, then copy by copy.
  int index(int copy, int i) const {
    if (i == sample_.size() - 1) return size() - 1;
    if (i == shared[1] && copy == count_ - 1 && n_own_u_ > 0) return size() - 2;
    for (int k = 0; k < n_shared; ++k)
      if (i == shared[k]) return k;
    return n_shared + n_own * copy + i -
           static_cast<int>(std::count_if(shared, shared + n_shared, [i](int s) { return s < i; }));
  }

  /// With the matrices of the copies from `begin` to `end`.
  System system(int begin, int end) const {
    System system;
    system.field.assign(static_cast<std::size_t>(size()), Field::displacement);
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
  int count_, n_own_u_;
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

class Division : public testing::Test {
 protected:
  std::shared_ptr<const Processes> processes_ = started_processes();  // at least two
  int rank_ = processes_->rank(), count_ = processes_->count();
};

class Divided : public Division, public testing::WithParamInterface<SchemeKind> {};

TEST_P(Divided, MarchesAsTheWholeDoes) {
  const Joined joined(count_);
  const Response whole = run(joined.system(0, count_), GetParam());
  System part = joined.system(rank_, rank_ + 1);
  const std::vector<int> index = divide(part, {}, processes_);
  const Response found = run(part, GetParam());
  expect_equal(found, whole);
  EXPECT_EQ(found.final_state.x.size(), 14);
  for (std::size_t i = 0; i < index.size(); ++i)
    if (index[i] >= 0) {
      EXPECT_NEAR(found.final_state.x[index[i]], whole.final_state.x[static_cast<Eigen::Index>(i)], 1e-11);
    }
}

INSTANTIATE_TEST_SUITE_P(Processes, Divided, testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha));

TEST_F(Division, HoldsOwnAndSharedUnknownsInTheirOrder) {
  const Joined joined(count_);
  System part = joined.system(rank_, rank_ + 1);
  const std::vector<int> index = divide(part, {joined.index(1, 2)}, processes_);
  const int own = rank_ == 1 ? 0 : 1;  // the unknown that every process is asked to hold is additional elsewhere
  EXPECT_EQ(part.size(), 14 + own);
  EXPECT_EQ(part.n_prescribed, 1);
  EXPECT_EQ(part.loads[1].prescribed, part.size() - 1);
  EXPECT_EQ(part.blocks.size(), 2U);
  EXPECT_EQ(index[joined.index(rank_, 6)], part.blocks[0].begin);
  for (int other = 0; other < count_; ++other) EXPECT_EQ(index[joined.index(other, 4)] >= 0, other == rank_);
  const int asked = index[joined.index(1, 2)];
  EXPECT_EQ(part.sharing.n_all, 4);
  if (count_ > 2 && rank_ == count_ - 1) {  // without the second u, which the others share
    EXPECT_EQ(part.sharing.unknowns, (std::vector<int>{0, 1, asked}));
    EXPECT_EQ(part.sharing.numbers, (std::vector<int>{0, 2, 3}));
  } else {
    EXPECT_EQ(part.sharing.unknowns, (std::vector<int>{0, 1, 2, asked}));
    EXPECT_EQ(part.sharing.numbers, (std::vector<int>{0, 1, 2, 3}));
  }
}

/// One process counts for each unknown: so loads and readings are sums over processes.
TEST_F(Division, DividesLoadsAndReadings) {
  const Joined joined(count_);
  System part = joined.system(rank_, rank_ + 1);
  const System whole = joined.system(0, count_);
  const std::vector<int> index = divide(part, {}, processes_);
  Vector load = Vector::Zero(whole.size()), reading = load;
  for (std::size_t i = 0; i < index.size(); ++i)
    if (index[i] >= 0) load[static_cast<Eigen::Index>(i)] = part.loads[0].vector[index[i]];
  for (const auto& [i, weight] : part.readings[2].acceleration)
    reading[std::find(index.begin(), index.end(), i) - index.begin()] += weight;
  processes_->sum(load.data(), whole.size());
  processes_->sum(reading.data(), whole.size());
  EXPECT_EQ(load, whole.loads[0].vector);
  for (const auto& [i, weight] : whole.readings[2].acceleration) EXPECT_EQ(reading[i], weight);
  EXPECT_EQ(reading.sum(), 2.);
}

TEST_F(Division, JoinsTheStateOfTheWhole) {
  const Joined joined_systems(count_);
  System part = joined_systems.system(rank_, rank_ + 1);
  const std::vector<int> index = divide(part, {}, processes_);
  State state = at_rest(part);
  state.time = 2.;
  for (std::size_t i = 0; i < index.size(); ++i)
    if (index[i] >= 0) {
      state.x[index[i]] = static_cast<double>(i);
      state.v[index[i]] = 100. + static_cast<double>(i);
      state.a[index[i]] = 0.1;
    }
  const State whole = joined(part, state);
  const int n = joined_systems.size();
  EXPECT_EQ(whole.time, 2.);
  EXPECT_EQ(whole.x, Vector::LinSpaced(n, 0., n - 1.));
  EXPECT_EQ(whole.v, Vector::LinSpaced(n, 100., 99. + n));
  EXPECT_EQ(whole.a, Vector::Constant(n, 0.1));
}

TEST_F(Division, NoticesSystemsOfDifferentSizes) {
  System part = Joined(2 + rank_).system(0, 1);
  EXPECT_THROW(divide(part, {}, processes_), NumericsError);
}

TEST_F(Division, StopsEarlyWhereTheWholeDoes) {
  const auto stopped = [](const System& system) {
    const auto scheme = make_scheme(system, {SchemeKind::sdirk4});
    MarchOptions options;
    options.stop_at_energy = 0.5;
    return march(system, *scheme, make_time_grid(kinks(system), 100., 0.25), options);
  };
  const auto push = [](System system) {  // for a second
    system.loads[0].history = piecewise_linear({0., 0.5, 1.}, {0., 1., 0.});
    system.loads[1].history = TimeFunction();
    return system;
  };
  const Joined joined(count_);
  const Response whole = stopped(push(joined.system(0, count_)));
  ASSERT_TRUE(whole.stopped_early);
  System part = push(joined.system(rank_, rank_ + 1));
  divide(part, {}, processes_);
  const Response found = stopped(part);
  EXPECT_TRUE(found.stopped_early);
  EXPECT_EQ(found.n_steps, whole.n_steps);
  expect_equal(found, whole);
}

}  // namespace divided_test
