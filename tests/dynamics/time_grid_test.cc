// Claims: steps meet every kink and the end, are no longer than asked, and are all equal where the kinks allow it;
// growing steps double and stay below their limit; counts too large for an int are refused. Tolerance 1e-9 relative
// as the grid promises.
#include "upbead/dynamics/time_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace time_grid_test {

using namespace upbead;

void expect_meets(const TimeGrid& grid, const std::vector<double>& kinks, double largest) {
  ASSERT_FALSE(grid.segments.empty());
  EXPECT_EQ(grid.segments.front().start, 0.);
  for (std::size_t i = 0; i < grid.segments.size(); ++i) {
    const TimeSegment& segment = grid.segments[i];
    const double next = i + 1 < grid.segments.size() ? grid.segments[i + 1].start : grid.end;
    EXPECT_NEAR(segment.start + segment.n_steps * segment.step, next, 1e-9 * grid.end);
    EXPECT_LE(segment.step, largest * (1. + 1e-9));
  }
  for (double kink : kinks) {
    double nearest = std::abs(kink - grid.end);
    for (const TimeSegment& segment : grid.segments) nearest = std::min(nearest, std::abs(segment.start - kink));
    EXPECT_LE(nearest, 1e-9 * grid.end) << kink;
  }
}

TEST(TimeGrid, OneSegmentWithoutKinks) {
  const TimeGrid grid = make_time_grid({}, 1., 0.3);
  ASSERT_EQ(grid.segments.size(), 1U);
  EXPECT_EQ(grid.segments[0].n_steps, 4);
  EXPECT_DOUBLE_EQ(grid.segments[0].step, 0.25);
}

TEST(TimeGrid, ACommonStepWhereThereIsOne) {
  const TimeGrid grid = make_time_grid({0., 0.05, 0.1}, 1., 0.003);  // 0.05 / 17 divides all
  expect_meets(grid, {0.05, 0.1}, 0.003);
  EXPECT_EQ(grid.n_step_sizes(), 1);
  EXPECT_EQ(grid.n_steps(), 340);
  const TimeGrid uneven = make_time_grid({0.02, 0.05}, 0.12, 0.0099);  // not 0.02 / 3: 0.05 is no multiple
  expect_meets(uneven, {0.02, 0.05}, 0.0099);
  EXPECT_EQ(uneven.n_step_sizes(), 1);
  EXPECT_DOUBLE_EQ(uneven.segments[0].step, 0.005);
}

TEST(TimeGrid, ElseAStepPerSegment) {
  const std::vector<double> kinks{0.1, 0.1 + std::sqrt(2.) / 10., 0.2 + std::sqrt(2.) / 10.};
  const TimeGrid grid = make_time_grid(kinks, 1., 0.01);
  expect_meets(grid, kinks, 0.01);
  EXPECT_EQ(grid.n_step_sizes(), 3) << "the first and the third segment are equally long";
  EXPECT_EQ(grid.segments[0].step, grid.segments[2].step);
}

TEST(TimeGrid, AKinkCloserThanHalfAStep) {
  const TimeGrid grid = make_time_grid({0.001}, 1., 0.1);
  expect_meets(grid, {0.001}, 0.1);
  EXPECT_EQ(grid.n_steps(), 11);
}

TEST(TimeGrid, NearKinksMergeAndOutsideOnesAreDropped) {
  const TimeGrid grid = make_time_grid({-1., 0., 1e-12, 0.5, 0.5 + 1e-11, 1. - 1e-12, 1., 7.}, 1., 0.1);
  expect_meets(grid, {0.5}, 0.1);
  EXPECT_EQ(grid.segments.size(), 2U);
}

TEST(TimeGrid, GrowingStepsReachFar) {
  const StepGrowth growth{0.1, 2e4};
  const TimeGrid grid = make_time_grid({0.05, 0.1, 3e5}, 1e6, 0.0125, growth);
  expect_meets(grid, {0.05, 0.1, 3e5}, growth.largest);
  EXPECT_EQ(grid.segments[0].step, 0.0125);
  EXPECT_EQ(grid.segments[1].step, 0.0125);
  for (std::size_t i = 1; i < grid.segments.size(); ++i)
    EXPECT_LE(grid.segments[i].step, 2. * grid.segments[i - 1].step * (1. + 1e-9)) << i;
  EXPECT_LE(grid.n_steps(), 300);
  EXPECT_LE(grid.n_step_sizes(), 26);
  EXPECT_NEAR(estimated_steps(3, 1e6, 0.0125, growth), grid.n_steps(), 0.3 * grid.n_steps());
}

TEST(TimeGrid, GrowingStepsFromTheStart) {
  const TimeGrid grid = make_time_grid({}, 100., 0.01, StepGrowth{0., 2.});
  expect_meets(grid, {}, 2.);
  EXPECT_EQ(grid.segments[0].step, 0.01);
}

TEST(TimeGrid, RefusesWhatNoIntCounts) {
  EXPECT_THROW(make_time_grid({}, 1., 1e-12), std::invalid_argument);
  EXPECT_THROW(make_time_grid({0.3}, 1e300, 1e-300), std::invalid_argument);
  EXPECT_THROW(make_time_grid({}, 1e300, 1e-3, StepGrowth{1e299, 1e298}), std::invalid_argument);
  EXPECT_NEAR(estimated_steps(0, 1., 1e-12), 1e12, 1.);
}

TEST(TimeGrid, AskWhetherALoadKeepsItsValue) {
  const TimeFunction ramp({0., 1.}, {[](double) { return 0.; }, [](double t) { return t; }, [](double) { return 1.; }});
  EXPECT_TRUE(keeps_value(ramp, 1., 0.1));
  EXPECT_FALSE(keeps_value(ramp, 0.5, 0.1));
  const TimeFunction sine({}, {[](double t) { return std::sin(t); }});
  for (double t : {0., 0.3, 1.5707963267948966}) EXPECT_FALSE(keeps_value(sine, t, 0.4)) << t;
}

TEST(TimeGrid, RefusesNonsense) {
  EXPECT_THROW(make_time_grid({}, 0., 0.1), std::invalid_argument);
  EXPECT_THROW(make_time_grid({}, 1., -0.1), std::invalid_argument);
  EXPECT_THROW(make_time_grid({}, std::nan(""), 0.1), std::invalid_argument);
}

}  // namespace time_grid_test
