// Claims: a reduced model on an exhausted space holds all unknowns of a march, with velocities, and accelerations but
// of phi; the distance of two responses is relative, in the norm of the energy, in which pressures count as well.
// Source: SDIRK of order 4 with small steps.
#include "upbead/dynamics/state_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reduction_tools.h"
#include "upbead/dynamics/reduce.h"

namespace state_model_test {

using namespace upbead;
using namespace upbead::test;

constexpr double end = 6.;

SampledLoads samples(const System& system) {
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : system.loads) histories.push_back(load.history);
  std::vector<double> time;
  for (int i = 0; i <= 48; ++i) time.push_back(i * end / 48.);
  return sample(histories, time);
}

Reduction reduced_with_states(const System& system) {
  ReduceOptions options;
  options.shift = 2.;
  options.training = samples(system);
  options.measured = {0};
  options.keep_states = true;
  return reduce(system, options);
}

void expect_equal(const Vector& found, const Vector& expected) {
  EXPECT_LT((found - expected).lpNorm<Eigen::Infinity>(), 1e-7 * std::max(1., expected.lpNorm<Eigen::Infinity>()));
}

TEST(StateModel, HoldsAllUnknownsOfAMarch) {
  const System system = loaded_sample(Sample{}, hat());
  const Reduction reduction = reduced_with_states(system);
  ASSERT_TRUE(reduction.states);
  const CoordinateSeries series = respond_in_coordinates(reduction.states->model, samples(system));
  std::vector<Eigen::Index> times;
  for (Eigen::Index i = 10; i <= 48; i += 2) times.push_back(i);  // more than are taken at once
  std::size_t seen = 0;
  for_each_state(*reduction.states, series, times, [&](const State& state, Eigen::Index at) {
    ASSERT_EQ(at, times[seen++]);
    const State marched = state_at(system, {}, state.time, 100 * static_cast<int>(at));
    expect_equal(state.x, marched.x);
    expect_equal(state.v, marched.v);
    for (int i = 0; i < system.size(); ++i) {
      const bool phi = system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse;
      EXPECT_NEAR(state.a[i], phi ? 0. : marched.a[i], 1e-5) << i;
    }
  });
  EXPECT_EQ(seen, times.size());
}

TEST(StateModel, MeasuresDistancesByEnergy) {
  const System system = loaded_sample(Sample{}, hat());
  const Reduction reduction = reduced_with_states(system);
  const CoordinateSeries fine = respond_in_coordinates(reduction.states->model, samples(system));
  CoordinateSeries coarse = fine;
  EXPECT_EQ(energy_distance(reduction.system, fine, coarse), 0.);
  for (Eigen::MatrixXd* part : {&coarse.position, &coarse.velocity}) *part *= 0.9;
  EXPECT_NEAR(energy_distance(reduction.system, fine, coarse), 0.1, 1e-12);
  coarse.position.conservativeResize(0, Eigen::NoChange);
  coarse.velocity.conservativeResize(0, Eigen::NoChange);
  EXPECT_NEAR(energy_distance(reduction.system, fine, coarse), 1., 1e-12) << "what a model lacks is zero";
  CoordinateSeries sealed = fine;
  for (const int i : reduction.states->phi.coordinate) sealed.velocity.row(i).setZero();
  EXPECT_GT(energy_distance(reduction.system, fine, sealed), 0.01) << "the water is compressed";
}

}  // namespace state_model_test
