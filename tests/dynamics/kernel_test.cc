// Claims: the convolution of a discrete kernel with a load's samples equals a march with that load on the same grid:
// with SDIRK for all loads that are straight within steps, also prescribed velocities, with generalised-alpha for
// forces without jumps; others are refused.
// Tolerance 1e-12 of the peak: 120 steps of round-off.
#include "discrete_kernel.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sample_system.h"

namespace kernel_test {

using namespace upbead;
using namespace upbead::test;

const SchemeOptions sdirk4{SchemeKind::sdirk4};
const SchemeOptions alpha{SchemeKind::generalised_alpha};
constexpr double step = 0.1;
constexpr int n_steps = 120;

TimeFunction triangle() {
  return piecewise_linear({0., 5. * step, 20. * step}, {0., 1., 0.});
}

TimeFunction step_load(double start) {
  return TimeFunction({start}, {[](double) { return 0.; }, [](double) { return 1.; }});
}

/// Jumps up at the start, ramps up, jumps down at 10 steps.
TimeFunction jumps() {
  return sum(sum(step_load(0.), triangle()), scaled(step_load(10. * step), -0.4));
}

/// The sample with a reading of each kind, one with feedthrough.
System with_readings(const Sample& sample) {
  System system = sample_system(sample);
  system.readings.push_back({"v1", "m/s", "", {}, {{1, 1.}}, {}, {0.7, 0.3}});
  return system;
}

Eigen::MatrixXd marched(const System& system, const SchemeOptions& options) {
  const TimeGrid grid{{{0., step, n_steps}}, n_steps * step};
  return march(system, *make_scheme(system, options), grid).ends.reading;
}

Eigen::MatrixXd convolved(const System& system, const SchemeOptions& options, int k) {
  const Kernel kernel = discrete_kernel(system, options, k, {0, 1, 2, 3}, step, n_steps);
  Eigen::VectorXd before(n_steps + 1), after(n_steps + 1);
  for (int n = 0; n <= n_steps; ++n) {
    before[n] = system.loads[k].history(n * step, (n - 0.5) * step);
    after[n] = system.loads[k].history(n * step, (n + 0.5) * step);
  }
  return convolve(kernel, before, after);
}

void expect_equal(const Eigen::MatrixXd& y, const Eigen::MatrixXd& expected, double tolerance) {
  ASSERT_EQ(y.cols(), expected.cols());
  for (Eigen::Index i = 0; i < y.rows(); ++i) {
    const double peak = expected.row(i).cwiseAbs().maxCoeff();
    EXPECT_GT(peak, 0.);
    EXPECT_LT((y.row(i) - expected.row(i)).cwiseAbs().maxCoeff(), tolerance * peak) << "reading " << i;
  }
}

TEST(Kernel, OfAForceWithSdirk) {
  for (const TimeFunction& f : {triangle(), step_load(0.), step_load(7. * step), jumps()})
    for (const double storage : {1., 0.}) {
      Sample sample;
      sample.storage = storage;
      System system = with_readings(sample);
      system.loads = {sample_load(system, f), sample_load(system, TimeFunction())};
      expect_equal(convolved(system, sdirk4, 0), marched(system, sdirk4), 1e-12);
    }
}

TEST(Kernel, OfAPrescribedVelocityWithSdirk) {
  for (const TimeFunction& f : {triangle(), jumps()})
    for (const bool phi : {false, true}) {
      Sample sample;
      (phi ? sample.prescribed_phi : sample.prescribed_u) = true;
      System system = with_readings(sample);
      system.loads = {prescribed_load(system, f), sample_load(system, TimeFunction())};
      expect_equal(convolved(system, sdirk4, 0), marched(system, sdirk4), 1e-12);
    }
}

TEST(Kernel, OfOneLoadAmongOthers) {
  System system = with_readings({});
  system.loads = {sample_load(system, triangle()), sample_load(system, jumps())};
  system.loads[0].vector = system.loads[0].vector.reverse().eval();
  expect_equal(convolved(system, sdirk4, 0) + convolved(system, sdirk4, 1), marched(system, sdirk4), 1e-12);
}

TEST(Kernel, OfAForceWithAlpha) {
  System system = with_readings({});
  system.loads = {sample_load(system, triangle()), sample_load(system, TimeFunction())};
  expect_equal(convolved(system, alpha, 0), marched(system, alpha), 1e-12);
}

TEST(Kernel, RefusesWhatItCannotDo) {
  Sample sample;
  sample.prescribed_u = true;
  System system = with_readings(sample);
  system.loads = {prescribed_load(system, triangle()), sample_load(system, jumps())};
  EXPECT_THROW(discrete_kernel(system, alpha, 0, {0}, step, 10), std::invalid_argument);
  EXPECT_THROW(discrete_kernel(system, sdirk4, 2, {0}, step, 10), std::out_of_range);
  EXPECT_THROW(discrete_kernel(system, sdirk4, 0, {4}, step, 10), std::out_of_range);
  const Kernel kernel = discrete_kernel(system, sdirk4, 0, {0}, step, 10);
  EXPECT_THROW(convolve(kernel, Eigen::VectorXd::Zero(10)), std::invalid_argument);
  EXPECT_THROW(convolved(system, alpha, 1), std::invalid_argument);
  system.loads[1].history = step_load(0.);
  EXPECT_THROW(convolved(system, alpha, 1), std::invalid_argument);
}

// The last step of the kernel is used, and the FFT does not wrap around.
TEST(Kernel, ReachesToTheEnd) {
  System system = with_readings({});
  system.loads = {sample_load(system, TimeFunction()), sample_load(system, TimeFunction())};
  const Kernel kernel = discrete_kernel(system, sdirk4, 0, {0, 3}, step, 30);
  Eigen::VectorXd first = Eigen::VectorXd::Zero(31), last = first;
  first[0] = last[30] = 1.;
  const double peak = kernel.left.cwiseAbs().maxCoeff();
  EXPECT_LT((convolve(kernel, first) - kernel.right).cwiseAbs().maxCoeff(), 1e-14 * peak) << "no load before t = 0";
  const Eigen::MatrixXd y = convolve(kernel, last);
  EXPECT_LT(y.leftCols(30).cwiseAbs().maxCoeff(), 1e-14 * peak);
  EXPECT_LT((y.col(30) - kernel.left.col(0)).cwiseAbs().maxCoeff(), 1e-14 * peak);
}

}  // namespace kernel_test
