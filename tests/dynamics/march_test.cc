// Claims: a march records ends and balanced states, is linear in the loads, stops early only once the loads
// are over, refuses numbers that are not finite, and factorises once per step size.
// Tolerance of superposition: 1e-11, some hundred steps of round-off.
#include "upbead/dynamics/march.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sample_system.h"
#include "upbead/base/error.h"

namespace march_test {

using namespace upbead;
using namespace upbead::test;

TimeFunction triangle(double rise, double duration) {
  return piecewise_linear({0., rise, duration}, {0., 1., 0.});
}

TEST(March, RecordsEveryStep) {
  System system = sample_system({});
  system.loads = {sample_load(system, triangle(0.5, 1.))};
  const auto scheme = make_scheme(system);
  int calls = 0;
  MarchOptions options;
  ObserverFunction count([&](const State& state, int step, int n_steps) {
    EXPECT_EQ(step, calls++);
    EXPECT_EQ(n_steps, 40);
    EXPECT_NEAR(state.time, 0.05 * step, 1e-12);
  });
  options.observers = {&count};
  const Response response = march(system, *scheme, make_time_grid(kinks(system), 2., 0.05), options);
  EXPECT_EQ(calls, 41);
  EXPECT_EQ(response.n_steps, 40);
  EXPECT_EQ(response.n_solves, 200);
  EXPECT_EQ(response.n_factorisations, 1);
  EXPECT_FALSE(response.stopped_early);
  EXPECT_EQ(response.energy.size(), 41U);
  EXPECT_EQ(response.ends.time.size(), 41U);
  EXPECT_EQ(response.ends.reading.cols(), 41);
  EXPECT_EQ(response.ends.reading.rows(), 3);
  EXPECT_EQ(response.ends.reading(0, 40), response.final_state.x[0]);
  EXPECT_EQ(response.ends.reading.col(0).norm(), 0.);
  EXPECT_NEAR(response.ends.load(0, 10), 1., 1e-12);
  EXPECT_EQ(response.ends.reading, response.balanced.reading) << "the end of a step of SDIRK is balanced";
}

TEST(March, BalancedTimesOfAlphaLieInsideTheSteps) {
  System system = sample_system({});
  system.loads = {sample_load(system, triangle(0.5, 1.))};
  const auto scheme = make_scheme(system, {SchemeKind::generalised_alpha, 0.9});
  const Response response = march(system, *scheme, make_time_grid(kinks(system), 2., 0.1));
  for (std::size_t i = 1; i < response.ends.time.size(); ++i)
    EXPECT_NEAR(response.balanced.time[i], response.ends.time[i] - 0.1 * 0.9 / 1.9, 1e-12);
}

TEST(March, IsLinear) {
  System system = sample_system({});
  const SystemLoad first = sample_load(system, triangle(0.5, 1.));
  SystemLoad second = sample_load(system, triangle(0.7, 1.5));
  second.vector = second.vector.reverse().eval();
  const TimeGrid grid = make_time_grid({0.5, 0.7, 1., 1.5}, 4., 0.05);
  for (SchemeKind kind : {SchemeKind::sdirk4, SchemeKind::generalised_alpha}) {
    const auto run = [&](const std::vector<SystemLoad>& loads) {
      system.loads = loads;
      return march(system, *make_scheme(system, {kind}), grid).ends.reading;
    };
    const Eigen::MatrixXd sum = run({first}) + run({second}), both = run({first, second});
    EXPECT_LT((sum - both).cwiseAbs().maxCoeff(), 1e-11 * both.cwiseAbs().maxCoeff());
  }
}

TEST(March, StopsEarlyOnlyAfterTheLastKink) {
  Sample sample;
  sample.damping = 2.;
  System system = sample_system(sample);
  system.loads = {sample_load(system, piecewise_linear({0., 0.5, 1., 30., 30.5, 31.}, {0., 1., 0., 0., 1., 0.}))};
  const auto scheme = make_scheme(system);
  MarchOptions options;
  options.stop_at_energy = 1e-6;
  const Response response = march(system, *scheme, make_time_grid(kinks(system), 200., 0.25), options);
  EXPECT_TRUE(response.stopped_early);
  EXPECT_GT(response.ends.time.back(), 31.);
  EXPECT_LT(response.ends.time.back(), 199.);
  EXPECT_LT(response.energy.back().stored(), 1e-6 * 10.);
  EXPECT_EQ(static_cast<int>(response.ends.reading.cols()), response.n_steps + 1);
  const auto blind = make_scheme(system, {SchemeKind::sdirk4, 0.9, false});
  EXPECT_THROW(march(system, *blind, make_time_grid({}, 1., 0.25), options), std::invalid_argument);
}

TEST(March, NeverStopsEarlyWhileALoadActs) {
  Sample sample;
  sample.damping = 20.;
  System system = sample_system(sample);
  const auto zero = [](double) { return 0.; };
  const auto harmonic = [](double t) { return std::sin(6. * t); };
  MarchOptions options;
  options.stop_at_energy = 0.9;  // the energy falls below this again and again while each of these loads acts
  const std::vector<TimeFunction> histories{
      TimeFunction({0.}, {zero, harmonic}),
      TimeFunction({0., 1.}, {zero, [](double t) { return 5. * (1. - t); }, [](double) { return 1e-3; }}),
      piecewise_linear({0., 1., 1.5, 60.}, {0., 1., 0.01, 0.})};
  for (std::size_t i = 0; i < histories.size(); ++i) {
    system.loads = {sample_load(system, histories[i])};
    const auto scheme = make_scheme(system);
    const Response response = march(system, *scheme, make_time_grid(kinks(system), 40., 0.1), options);
    EXPECT_FALSE(response.stopped_early) << i;
    EXPECT_DOUBLE_EQ(response.ends.time.back(), 40.) << i;
    double largest = 0.;
    for (const EnergyAccount& energy : response.energy) largest = std::max(largest, energy.stored());
    EXPECT_LT(response.energy.back().stored(), 0.9 * largest) << i << ": the energy alone would have stopped it";
  }
}

// More step sizes than factors that are kept: older factors are overwritten in place.
TEST(March, ManyStepSizesAgreeWithOne) {
  System system = sample_system({});
  const double r = std::sqrt(2.), p = std::acos(-1.);
  system.loads = {sample_load(system, piecewise_linear({0., 1. / r, 1. / p + 1., p - 1.1, p}, {0., 1., .2, -.3, 0.}))};
  const auto scheme = make_scheme(system), fine = make_scheme(system);
  const TimeGrid grid = make_time_grid(kinks(system), 4., 0.02);
  EXPECT_EQ(grid.n_step_sizes(), 5);
  const Response response = march(system, *scheme, grid);
  EXPECT_EQ(response.n_factorisations, 5);
  const State reference = march(system, *fine, make_time_grid(kinks(system), 4., 0.005)).final_state;
  // Order 4 at this step.
  EXPECT_LT((response.final_state.x - reference.x).norm(), 1e-6 * reference.x.norm());
}

TEST(March, RefusesWhatIsNotFinite) {
  System system = sample_system({});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  system.loads = {sample_load(system, TimeFunction({0.5}, {[](double) { return 1.; }, [=](double) { return nan; }}))};
  const auto scheme = make_scheme(system);
  EXPECT_THROW(march(system, *scheme, make_time_grid(kinks(system), 1., 0.1)), NumericsError);
}

// Wrong signs on phi: the effective matrix is not quasi-definite in the expected way.
TEST(March, RefusesASystemThatIsNotWellPosed) {
  System system = sample_system({});
  system.field[12] = Field::displacement;
  system.loads = {sample_load(system, smooth())};
  const auto scheme = make_scheme(system);
  State state = at_rest(system);
  EXPECT_THROW(scheme->advance(state, 0.1), NumericsError);
  EXPECT_THROW(make_scheme(system, {SchemeKind::generalised_alpha, 1.5}), std::invalid_argument);
}

}  // namespace march_test
