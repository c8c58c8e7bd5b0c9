// Claims, on as many processes as mpirun starts: a system divided among them marches like the whole system, with the
// same readings and energies; each process holds its own unknowns and those that it shares; it is reduced to the model
// of the whole; a checkpoint is the same for any number of processes. Tolerance: 1e-11, some hundred steps of
// round-off.
#include <gtest/gtest.h>

#include "dynamics/joined.h"
#include "dynamics/projection.h"
#include "dynamics/state_space.h"
#include "sample_system.h"
#include "system/part.h"
#include "upbead/base/error.h"
#include "upbead/dynamics/nested_models.h"
#include "upbead/dynamics/reduce.h"

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

/// By a model whose error is measured on two load histories.
Reduction reduced(const System& system, double tolerance) {
  std::vector<double> time;
  for (int i = 0; i <= 80; ++i) time.push_back(0.05 * i);
  ReduceOptions options;
  options.shift = 3.;
  options.training = sample(load_histories(system), time);
  options.measured = {0};
  options.tolerance = options.tolerance_of_others = options.tolerance_of_states = tolerance;
  options.first_vectors = 3;
  options.keep_states = true;
  return reduce(system, options);
}

/// All states of a model under its loads, side by side; `whole` makes them those of the whole system.
Eigen::MatrixXd states(const Reduction& reduction, const System& system,
                       const std::function<State(const State&)>& whole) {
  std::vector<Eigen::Index> times;
  std::vector<double> time;
  for (int i = 0; i <= 40; ++i) time.push_back(0.1 * i), times.push_back(i);
  const SampledLoads loads = sample(load_histories(system), time);
  Eigen::MatrixXd all;
  for_each_state(*reduction.states, respond_in_coordinates(reduction.states->model, loads), times,
                 [&](const State& state, Eigen::Index i) {
                   const State joint = whole(state);
                   if (i == 0) all.resize(joint.x.size(), 2 * static_cast<Eigen::Index>(times.size()));
                   all.col(2 * i) = joint.x;
                   all.col(2 * i + 1) = joint.v;
                 });
  return all;
}

TEST_F(Division, IsReducedToTheModelOfTheWhole) {
  const Joined systems(count_);
  const System whole = systems.system(0, count_);
  System part = systems.system(rank_, rank_ + 1);
  divide(part, {}, processes_);
  const Reduction expected = reduced(whole, 0.02), found = reduced(part, 0.02);
  ASSERT_TRUE(expected.converged);
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.n_vectors, expected.n_vectors);
  EXPECT_EQ(found.n_independent_loads, expected.n_independent_loads);
  EXPECT_NEAR(found.error.history, expected.error.history, 1e-9);
  std::vector<double> time;
  for (int i = 0; i <= 80; ++i) time.push_back(0.05 * i);
  const SampledLoads loads = sample(load_histories(whole), time);
  const Eigen::MatrixXd here = respond(found.model, loads).reading, there = respond(expected.model, loads).reading;
  for (Eigen::Index i = 0; i < there.rows(); ++i)
    EXPECT_LT((here.row(i) - there.row(i)).cwiseAbs().maxCoeff(), 1e-10 * there.row(i).cwiseAbs().maxCoeff()) << i;
  const Eigen::MatrixXd all = states(expected, whole, [](const State& state) { return state; });
  const Eigen::MatrixXd joint = states(found, part, [&](const State& state) { return joined(part, state); });
  EXPECT_LT((joint - all).cwiseAbs().maxCoeff(), 1e-9 * all.cwiseAbs().maxCoeff());
}

/// A model of few vectors is not exact, so that it is the same only where the spaces are the same.
TEST_F(Division, SpansTheSpaceOfTheWhole) {
  const Joined systems(count_);
  const System whole = systems.system(0, count_);
  System part = systems.system(rank_, rank_ + 1);
  divide(part, {}, processes_);
  const auto model_of = [](const System& system, int n_vectors) {
    SecondOrderKrylov krylov(system, 3.);
    while (krylov.n_vectors() < n_vectors && krylov.extend()) {
    }
    const ReducedSystem projected = Projection(system, krylov).reduced();
    return modal_model(state_space(projected), projected);
  };
  const ModalModel found = model_of(part, 5), expected = model_of(whole, 5), exact = model_of(whole, 1000);
  const std::complex<double> s(0.3, 1.);
  for (int i = 0; i < found.n_readings(); ++i)
    for (int k = 0; k < found.n_loads(); ++k) {
      const std::complex<double> H = expected.transfer(i, k, s);
      EXPECT_LT(std::abs(found.transfer(i, k, s) - H), 1e-11 * std::abs(H)) << i << " " << k;
      EXPECT_GT(std::abs(exact.transfer(i, k, s) - H), 1e-6 * std::abs(H)) << i << " " << k;
    }
}

/// Joined directions give the states of the whole by themselves, but for rounding: how BLAS orders the sums of a
/// product depends on its number of rows, on some processors.
TEST_F(Division, JoinsTheDirectionsOfAModel) {
  const Joined systems(count_);
  System part = systems.system(rank_, rank_ + 1);
  divide(part, {}, processes_);
  Reduction found = reduced(part, 0.02);
  const Eigen::MatrixXd joint = states(found, part, [&](const State& state) { return joined(part, state); });
  found.states->displacements = joined(part, found.states->displacements);
  found.states->phi = joined(part, found.states->phi);
  const Eigen::MatrixXd own = states(found, part, [](const State& state) { return state; });
  EXPECT_LT((own - joint).cwiseAbs().maxCoeff(), 1e-14 * joint.cwiseAbs().maxCoeff());
}

/// Spaces about several shifts, joined.
TEST_F(Division, IsReducedAboutSeveralShiftsAsTheWholeIs) {
  const Joined systems(count_);
  const System whole = systems.system(0, count_);
  System part = systems.system(rank_, rank_ + 1);
  divide(part, {}, processes_);
  const NestedSpace space{3., 6, {}};
  const NestedModels expected = nested_models(whole, space, {0, 2}, {}), found = nested_models(part, space, {0, 2}, {});
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i) {
      const std::complex<double> s(0.3, 1.), H = expected.reference.transfer(i, k, s);
      EXPECT_LT(std::abs(found.reference.transfer(i, k, s) - H), 1e-9 * std::abs(H));
    }
}

/// Of the whole march, and all its checkpoints.
Response kept(const System& system, SchemeKind kind, std::vector<MarchCheckpoint>& all,
              std::shared_ptr<const MarchCheckpoint> from = nullptr) {
  const auto scheme = make_scheme(system, {kind});
  MarchOptions options;
  options.checkpoints.due = [] { return true; };
  options.checkpoints.keep = [&all](const MarchCheckpoint& checkpoint) { all.push_back(checkpoint); };
  options.checkpoints.resume_from = std::move(from);
  return march(system, *scheme, make_time_grid(kinks(system), 4., 0.1), options);
}

TEST_P(Divided, GoesOnFromACheckpointOfAnyNumberOfProcesses) {
  const Joined systems(count_);
  const System whole = systems.system(0, count_);
  System part = systems.system(rank_, rank_ + 1);
  divide(part, {}, processes_);
  std::vector<MarchCheckpoint> of_one, of_all, again;
  const Response expected = kept(whole, GetParam(), of_one);
  expect_equal(kept(part, GetParam(), of_all), expected);
  ASSERT_EQ(of_all.size(), of_one.size());
  ASSERT_GT(of_one.size(), 30U);
  for (const std::size_t step : {std::size_t{0}, std::size_t{20}}) {
    const auto one = std::make_shared<const MarchCheckpoint>(of_one[step]);
    const auto all = std::make_shared<const MarchCheckpoint>(of_all[step]);
    EXPECT_EQ(all->so_far.final_state.x.size(), whole.size());
    expect_equal(kept(part, GetParam(), again, one), expected);
    expect_equal(kept(part, GetParam(), again, all), expected);
    expect_equal(kept(whole, GetParam(), again, all), expected);
  }
}

/// All keep a checkpoint where one of them finds it due, and one that does not keep any takes part.
TEST_F(Division, KeepsACheckpointWhereOneProcessFindsItDue) {
  System part = Joined(count_).system(rank_, rank_ + 1);
  divide(part, {}, processes_);
  const auto scheme = make_scheme(part, {SchemeKind::sdirk4});
  MarchOptions options;
  int asked = 0, n_kept = 0;
  if (rank_ == count_ - 1) options.checkpoints.due = [&asked] { return ++asked == 3; };
  if (rank_ == 0)
    options.checkpoints.keep = [&n_kept](const MarchCheckpoint& checkpoint) {
      ++n_kept;
      EXPECT_EQ(checkpoint.so_far.n_steps, 3);
    };
  march(part, *scheme, make_time_grid(kinks(part), 1., 0.1), options);
  EXPECT_EQ(n_kept, rank_ == 0 ? 1 : 0);
}

}  // namespace divided_test
