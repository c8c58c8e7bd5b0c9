// Claim: a march that is resumed from a checkpoint equals the uninterrupted march to the last bit: at every step of
// both schemes, over jumps of a load (where generalised-alpha starts anew), changes of the step size and an early
// stop.
#include "upbead/dynamics/march.h"

#include <gtest/gtest.h>

#include "sample_system.h"
#include "upbead/base/error.h"

namespace checkpoint_test {

using namespace upbead;
using namespace upbead::test;

class Checkpoint : public testing::TestWithParam<SchemeKind> {
 protected:
  Checkpoint() : system_(sample_system({})) {
    system_.loads = {sample_load(system_, piecewise_linear({0.1, 0.5, 1.2}, {0.3, 1., 0.})),
                     sample_load(system_, TimeFunction({0.}, {[](double) { return 0.; }, [](double) { return 0.2; }}))};
    system_.loads[1].vector = system_.loads[1].vector.reverse().eval();
  }
  Response resumed(const MarchCheckpoint& from, double stop_at_energy = 0.) const {
    MarchOptions options;
    options.stop_at_energy = stop_at_energy;
    options.checkpoints.resume_from = std::make_shared<const MarchCheckpoint>(from);
    return run(options);
  }
  Response run(const MarchOptions& options) const {
    return march(system_, *make_scheme(system_, {GetParam()}), make_time_grid(kinks(system_), 3.03, 0.07), options);
  }
  /// The whole march, and a checkpoint after every step.
  Response remembered(std::vector<MarchCheckpoint>& all, double stop_at_energy = 0.) const {
    MarchOptions options;
    options.stop_at_energy = stop_at_energy;
    options.checkpoints.due = [] { return true; };
    options.checkpoints.keep = [&all](const MarchCheckpoint& checkpoint) { all.push_back(checkpoint); };
    return run(options);
  }
  static void expect_same(const Response& a, const Response& b, int step) {
    EXPECT_EQ(a.ends.time, b.ends.time) << step;
    EXPECT_EQ(a.balanced.time, b.balanced.time) << step;
    for (const auto series : {&Response::ends, &Response::balanced, &Response::inside}) {
      EXPECT_EQ((a.*series).reading, (b.*series).reading) << step;
      EXPECT_EQ((a.*series).load, (b.*series).load) << step;
    }
    EXPECT_EQ(a.final_state.a, b.final_state.a) << step;
    EXPECT_EQ(a.n_steps, b.n_steps) << step;
    EXPECT_EQ(a.n_solves, b.n_solves) << step;
    ASSERT_EQ(a.energy.size(), b.energy.size()) << step;
    for (std::size_t i = 0; i < a.energy.size(); ++i) {
      EXPECT_EQ(a.energy[i].work, b.energy[i].work) << step;
      EXPECT_EQ(a.energy[i].scheme, b.energy[i].scheme) << step;
      EXPECT_EQ(a.energy[i].largest_work, b.energy[i].largest_work) << step;
    }
  }
  System system_;
};

INSTANTIATE_TEST_SUITE_P(Schemes, Checkpoint, testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha));

TEST_P(Checkpoint, GoesOnToTheLastBit) {
  std::vector<MarchCheckpoint> all;
  const Response whole = remembered(all);
  ASSERT_GT(all.size(), 40U);
  expect_same(run({}), whole, -1);
  for (const MarchCheckpoint& checkpoint : all) expect_same(resumed(checkpoint), whole, checkpoint.so_far.n_steps);
}

TEST_P(Checkpoint, StopsEarlyWhereTheWholeMarchDoes) {
  system_.loads.pop_back();  // a step load never ends
  std::vector<MarchCheckpoint> all;
  const Response whole = remembered(all, 0.9);
  ASSERT_TRUE(whole.stopped_early);
  ASSERT_GT(all.size(), 2U);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const Response again = resumed(all[i], 0.9);
    EXPECT_TRUE(again.stopped_early) << i;
    expect_same(again, whole, static_cast<int>(i));
  }
}

TEST_P(Checkpoint, ObserverSeesTheStateThatItBeginsAt) {
  std::vector<MarchCheckpoint> all;
  remembered(all);
  std::vector<int> seen;
  MarchOptions options;
  options.checkpoints.resume_from = std::make_shared<const MarchCheckpoint>(all[4]);
  ObserverFunction note([&seen](const State&, int step, int) { seen.push_back(step); });
  options.observers = {&note};
  run(options);
  ASSERT_EQ(seen.size(), all.size() - 4);
  EXPECT_EQ(seen.front(), 5);
}

TEST_P(Checkpoint, OfAnotherSystemIsRefused) {
  std::vector<MarchCheckpoint> all;
  remembered(all);
  const auto refused = [&](auto change) {
    MarchCheckpoint other = all[4];
    change(other);
    EXPECT_THROW(resumed(other), NumericsError);
  };
  refused([](MarchCheckpoint& other) { other.so_far.final_state.x.conservativeResize(3); });
  refused([](MarchCheckpoint& other) { other.so_far.ends.reading.conservativeResize(1, Eigen::NoChange); });
  refused([](MarchCheckpoint& other) { other.so_far.balanced.time.pop_back(); });
  refused([](MarchCheckpoint& other) { other.so_far.n_steps = 1000000; });
  refused([](MarchCheckpoint& other) { other.memory.end_load.clear(); });
}

}  // namespace checkpoint_test
