// Claims, on as many processes as mpirun starts: two models grow side by side until the first process finds their
// difference settled, on all processes alike, also where others find something else or cannot read a model at all;
// what each has compared for itself is kept where all have it.
#include <gtest/gtest.h>

#include "run/accuracy/accuracy.h"
#include "run/accuracy/side_by_side.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace side_by_side_divided_test {

using namespace upbead;

constexpr int n_masses = 60;

/// A chain of masses with the springs and dashpots from `begin` to `end`; the first spring holds it.
System chain(int begin, int end) {
  std::vector<Eigen::Triplet<double>> M, C, K;
  const auto add = [](int i, int j, double value, auto& to) {
    to.emplace_back(j, j, value);
    if (i < 0) return;
    to.emplace_back(i, i, value);
    to.emplace_back(i, j, -value);
    to.emplace_back(j, i, -value);
  };
  for (int j = begin; j < end; ++j) {
    M.emplace_back(j, j, 1.);
    add(j - 1, j, 0.1, C);
    add(j - 1, j, 10. + j % 7, K);
  }
  System system;
  system.field.assign(n_masses, Field::displacement);
  for (const auto& [matrix, entries] :
       {std::pair{&System::M, &M}, std::pair{&System::C, &C}, std::pair{&System::K, &K}}) {
    (system.*matrix).resize(n_masses, n_masses);
    (system.*matrix).setFromTriplets(entries->begin(), entries->end());
  }
  system.radiation.resize(n_masses, n_masses);
  const TimeFunction pulse = piecewise_linear({0., 1., 2.}, {0., 1., 0.});
  system.loads = {{"push", Vector::Unit(n_masses, n_masses - 1), pulse, -1}};
  system.readings = {position_reading("end", "m", "", {{n_masses - 1, 1.}})};
  return system;
}

ReduceOptions options_of(const System& system) {
  std::vector<double> time;
  for (int i = 0; i <= 100; ++i) time.push_back(0.1 * i);
  ReduceOptions options;
  options.shift = 1.;
  options.training = sample(load_histories(system), time);
  options.measured = {0};
  options.tolerance = options.tolerance_of_others = 1e-12;  // out of reach of the looks that are taken here
  options.first_vectors = 3;
  return options;
}

class SideBySideAmong : public testing::Test {
 protected:
  SideBySideAmong() {
    const int each = n_masses / processes_->count();
    part_ = chain(rank_ * each, rank_ + 1 == processes_->count() ? n_masses : (rank_ + 1) * each);
    divide(part_, {}, processes_);
  }
  /// The answer of both models is `answer` of the number of vectors, and the finer's is larger by 1.
  int grown(const std::function<double(int)>& answer) {
    GrowingModel coarse(part_, options_of(part_)), finer(whole_, options_of(whole_));
    int n = 0;
    const auto read = [&](const GrowingModel& model) -> Answers {
      n = model.reduction().n_vectors;
      const double value = answer(n);
      return {Eigen::VectorXd::Constant(1, &model == &finer ? 1. + value : 0.)};
    };
    const auto found = grow_side_by_side(coarse, finer, read, 0., layout_of(part_));
    EXPECT_TRUE(found);
    return n;
  }

  std::shared_ptr<const Processes> processes_ = started_processes();
  int rank_ = processes_->rank();
  System part_, whole_ = chain(0, n_masses);
};

/// Left to itself, each process but the first would never stop, or stop at once: the others would wait for ever.
TEST_F(SideBySideAmong, StopsWhereTheFirstProcessDoes) {
  std::vector<int> settled;
  for (const int sign : {1, -1}) {
    int looks = 0;
    const int n = grown([&](int) {
      ++looks;
      const bool changes = rank_ == 0 ? looks < 7 : sign > 0;  // two answers a look
      return changes ? 10. * looks : 0.;
    });
    settled.push_back(n);
    const Layout layout = layout_of(part_);
    EXPECT_EQ(layout.largest(n), n) << "all have as many vectors";
    EXPECT_EQ(looks, 10);
  }
  EXPECT_EQ(settled[0], settled[1]);
}

TEST_F(SideBySideAmong, GoesOnWhereOneProcessCannotRead) {
  int looks = 0;
  const int n = grown([&](int) {
    if (++looks == 1 && rank_ > 0) throw NumericsError("too few vectors");
    return 0.;
  });
  EXPECT_EQ(layout_of(part_).largest(n), n);
}

/// Where a mesh is made for the tolerance each process compares for itself: one with reduced models would wait in what
/// follows for one without.
TEST_F(SideBySideAmong, KeepsReducedModelsWhereAllHaveThem) {
  const Layout layout = layout_of(part_);
  for (const int lacks : {-1, 0, 1}) {
    CellsCompared compared;
    compared.error = {0.1 + rank_, 0.2 + rank_};
    if (rank_ != lacks) compared.reduced.emplace();
    agree(compared, layout);
    EXPECT_EQ(compared.reduced.has_value(), lacks < 0);
    EXPECT_EQ(compared.error.peak, 0.1);
    EXPECT_EQ(compared.error.history, 0.2);
  }
}

}  // namespace side_by_side_divided_test
