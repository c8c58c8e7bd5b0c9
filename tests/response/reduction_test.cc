// Claims: the times of a reduced response include the kinks of the loads and the samples of rough records, and have
// the case's own step if it resolves the loads; a model that has not converged is refused with its error and the
// worst reading; the error of a scene's model against a march is below the tolerance.
#include "response/reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace reduction_test {

constexpr double duration = 0.15, end = 0.5;

/// The breakwater's front loaded by a given history.
struct Loaded {
  explicit Loaded(const TimeFunction& history) : scene(breakwater(history)) {
    scene.time.end = end;
    SystemLoad load;
    load.history = history;
    system.loads = {load};
  }
  std::vector<double> times() const { return response_times(scene, system); }
  Scene scene;
  System system;
};

double largest_step(const std::vector<double>& time) {
  double largest = 0.;
  for (std::size_t i = 1; i < time.size(); ++i) largest = std::max(largest, time[i] - time[i - 1]);
  return largest;
}

bool holds(const std::vector<double>& time, double t) {
  return std::any_of(time.begin(), time.end(), [t](double at) { return std::abs(at - t) < 1e-9 * end; });
}

TEST(ResponseTimes, MeetTheKinks) {
  const Loaded loaded(triangle(1., duration, 0.0371));
  const std::vector<double> time = loaded.times();
  EXPECT_EQ(time.front(), 0.);
  EXPECT_NEAR(time.back(), end, 1e-12);
  EXPECT_TRUE(std::is_sorted(time.begin(), time.end()));
  for (const double kink : loaded.system.loads[0].history.kinks()) EXPECT_TRUE(holds(time, kink)) << kink;
  EXPECT_LE(largest_step(time), 2. * 0.0371 / 32. + 1e-12) << "the rise is half of the shortest duration";
  EXPECT_GT(largest_step(time), 0.0371 / 32.);
}

TEST(ResponseTimes, KeepTheCasesOwnStep) {
  Loaded loaded(triangle(1., duration));
  loaded.scene.time.step = 0.025;
  const std::vector<double> time = loaded.times();
  EXPECT_EQ(time.size(), 21u);
  EXPECT_NEAR(largest_step(time), 0.025, 1e-12);
}

/// Sampled in steps of 0.1 s, a load of 9 Hz would look like one of 1 Hz.
TEST(ResponseTimes, FollowALoadThatTheCasesStepWouldNotSee) {
  constexpr double omega = 18. * 3.14159265358979;
  Loaded loaded(TimeFunction({}, {[=](double t) { return std::sin(omega * t); }}));
  loaded.scene.loads["impulse"].duration = 1. / 36.;
  loaded.scene.time.step = 0.1;
  EXPECT_LT(largest_step(loaded.times()), 1e-3);
}

/// It is over before the first step ends.
TEST(ResponseTimes, FollowWhatTheFirstStepWouldNotSee) {
  constexpr double omega = 20. * 3.14159265358979;
  Loaded loaded(TimeFunction({0.1}, {[=](double t) { return std::sin(omega * t); }, [](double) { return 0.; }}));
  loaded.scene.loads["impulse"].duration = 1. / 40.;
  loaded.scene.time.step = 0.1;
  EXPECT_LT(largest_step(loaded.times()), 1e-2);
}

/// 80 s of 1000 Hz: the answer would hold gigabytes. Lines between kinks need no more times, however short.
TEST(ResponseTimes, AreNotMillions) {
  constexpr double omega = 2000. * 3.14159265358979;
  Loaded loaded(TimeFunction({}, {[=](double t) { return std::sin(omega * t); }}));
  loaded.scene.loads["impulse"].duration = 0.5e-3;
  loaded.scene.time.end = 80.;
  loaded.scene.time.step = 10.;
  EXPECT_THROW(loaded.times(), NumericsError);
  loaded.system.loads[0].history = triangle(1., 0.5e-3);
  EXPECT_LT(loaded.times().size(), 20U);
}

TEST(ResponseTimes, HoldTheSamplesOfARoughRecord) {
  std::vector<double> samples, values;
  for (int i = 0; i <= 200; ++i) {
    samples.push_back(0.0013 * i);
    values.push_back(std::sin(0.0013 * i * 12.) + 0.1 * std::sin(2.6 * i * i));
  }
  Loaded loaded(piecewise_linear(samples, values));
  ASSERT_TRUE(is_rough(loaded.system.loads[0].history));
  loaded.scene.loads["impulse"].duration = duration;
  const std::vector<double> time = loaded.times();
  for (const double sample : samples) EXPECT_TRUE(holds(time, sample)) << sample;
  EXPECT_LE(largest_step(time), duration / 32. + 1e-12);
  for (std::size_t i = 1; i < time.size(); ++i) EXPECT_GT(time[i] - time[i - 1], 1e-9 * end) << "no time twice";
}

TEST(RequireConverged, SaysHowFarItIsAndWhere) {
  Reduction reduction;
  reduction.model.reading_label = {{"good", "", ""}, {"bad", "", ""}};
  EXPECT_EQ(worst_reading(reduction), "");
  reduction.error = {0.031, 0.02, 0.5, 0., Eigen::Vector2d(0.031, 0.5)};
  reduction.n_solves = 77;
  reduction.tolerance = 0.005;
  reduction.tolerance_of_others = 0.05;
  EXPECT_EQ(worst_reading(reduction), "bad");
  try {
    require_converged(reduction);
    FAIL() << "did not throw";
  } catch (const NumericsError& error) {
    for (const char* part :
         {"77 solves", "3.1 %", "0.5 %", "least certain of all else is bad, by 50 %", "matters where it is read"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << part << " in: " << error.what();
  }
  reduction.converged = true;
  EXPECT_NO_THROW(require_converged(reduction));
}

TEST(ReduceScene, ErrsByLessThanAskedFor) {
  Scene scene = breakwater(triangle(1.6e6, duration));
  scene.time.end = end;
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh);
  const Reduction reduction = reduce_scene(compiled.resolved, compiled.scene, {});
  ASSERT_TRUE(reduction.converged);
  EXPECT_LE(reduction.error.history, scene.tolerance);
  EXPECT_LE(reduction.error.others, 10. * scene.tolerance);
  const double error = error_against_march(reduction, compiled.resolved, compiled.scene);
  EXPECT_GT(error, 0.);
  EXPECT_LE(error, scene.tolerance);
  EXPECT_LE(reduce_scene(compiled.resolved, compiled.scene, {true, false, {}}).n_vectors, reduction.n_vectors);
  Scene strict = compiled.resolved;
  strict.tolerance = 1e-7;
  const Reduction few = reduce_scene(strict, compiled.scene, {false, false, 25});
  EXPECT_FALSE(few.converged);
  EXPECT_EQ(few.n_vectors, 24) << "the last look that fits";
}

}  // namespace reduction_test
}  // namespace upbead::test
