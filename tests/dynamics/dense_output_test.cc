// Claims: between the ends of its steps a march is as accurate as at these ends, in x, x' and x'', with the loads
// themselves, also after a jump of a load; nearly as accurate without inertia and with a prescribed velocity.
// Reference: a march in 4,000 steps whose ends include the times. Limits: orders, by regression; docs/theory.md.

#include "dynamics/dense_output.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_system.h"

namespace upbead::test {
namespace dense_output_test {

constexpr double end = 4.;

std::vector<double> odd_times() {
  std::vector<double> times;
  for (int i = 0; i < 37; ++i) times.push_back(end * (i + 0.37) / 37.);
  return times;
}

void read_free_unknowns(System& system) {
  const int u = 0;
  system.readings = {position_reading("x", "m", "", {{u, 1.}}), velocity_reading("v", "m/s", "", {{u, 1.}}),
                     acceleration_reading("a", "m/s2", "", {{u, 1.}})};
  Reading all{"all", "N", "", {{u, 1.}, {1, 2.}}, {{2, 0.5}}, {{0, 0.3}}, {1.}};
  system.readings.push_back(all);
}

Series marched(const System& system, int n, bool inertia, const std::vector<double>& times) {
  DenseRecorder dense(system, times, inertia);
  MarchOptions options;
  options.observers = {&dense};
  const auto scheme = make_scheme(system);
  march(system, *scheme, make_time_grid(kinks(system), end, end / n), options);
  return dense.series();
}

Series reference(const System& system, const std::vector<double>& times) {
  std::vector<double> all = kinks(system);
  all.insert(all.end(), times.begin(), times.end());
  std::sort(all.begin(), all.end());
  const auto scheme = make_scheme(system);
  return at_times(march(system, *scheme, make_time_grid(all, end, end / 4000.)).ends, times, 1e-9);
}

/// Largest errors by number of steps and reading: between the ends of the steps, and at them.
struct Errors {
  Eigen::MatrixXd between, at_ends;
};

Errors errors_of(const System& system, bool inertia, double from = 0.) {
  std::vector<double> times, ends;
  for (const double t : odd_times())
    if (t > from) times.push_back(t);
  for (int i = 1; i <= 20; ++i)
    if (end * i / 20. > from) ends.push_back(end * i / 20.);
  const Series exact = reference(system, times), exact_ends = reference(system, ends);
  Errors errors{Eigen::MatrixXd(system.readings.size(), 4), Eigen::MatrixXd(system.readings.size(), 4)};
  int column = 0;
  for (const int steps : {20, 40, 80, 160}) {
    errors.between.col(column) =
        (marched(system, steps, inertia, times).reading - exact.reading).cwiseAbs().rowwise().maxCoeff();
    errors.at_ends.col(column++) =
        (marched(system, steps, inertia, ends).reading - exact_ends.reading).cwiseAbs().rowwise().maxCoeff();
  }
  return errors;
}

std::vector<double> orders(const System& system, bool inertia, double from = 0.) {
  const Errors errors = errors_of(system, inertia, from);
  std::vector<double> list;
  for (Eigen::Index r = 0; r < errors.between.rows(); ++r)
    list.push_back(order({20, 40, 80, 160},
                         {errors.between(r, 0), errors.between(r, 1), errors.between(r, 2), errors.between(r, 3)}));
  return list;
}

TEST(DenseOutput, HasTheOrderOfTheScheme) {
  System system = sample_system({});
  system.loads = {sample_load(system, smooth())};
  read_free_unknowns(system);
  const std::vector<double> p = orders(system, true);
  EXPECT_GE(p[0], 3.8);
  EXPECT_GE(p[1], 3.8);
  EXPECT_GE(p[2], 2.8);  // x'' is computed from x and x' at the ends, whose error is h^4
  EXPECT_GE(p[3], 2.8);
  const Errors errors = errors_of(system, true);
  EXPECT_LE((errors.between.topRows(1) - 1.1 * errors.at_ends.topRows(1)).maxCoeff(), 0.);
}

TEST(DenseOutput, HasItAfterAJump) {
  System system = sample_system({});
  system.loads = {sample_load(system, jump())};
  read_free_unknowns(system);
  const std::vector<double> p = orders(system, true);
  EXPECT_GE(p[0], 3.8);
  EXPECT_GE(p[1], 3.8);
  EXPECT_GE(p[2], 2.8);
}

TEST(DenseOutput, FollowsAPrescribedVelocity) {
  Sample sample;
  sample.prescribed_u = true;
  System system = sample_system(sample);
  system.loads = {prescribed_load(system, smooth())};
  read_free_unknowns(system);
  const std::vector<double> p = orders(system, true);
  EXPECT_GE(p[0], 3.7);
  EXPECT_GE(p[1], 2.7);
}

TEST(DenseOutput, OfConsolidationIsAboutAsGoodAsItsSteps) {
  constexpr int nodes = 6;
  System system = consolidation(nodes, smooth());
  system.readings = {position_reading("settlement", "m", "", {{0, 1.}}),
                     velocity_reading("pressure", "Pa", "", {{2 * nodes - 1, 1.}})};
  EXPECT_GE(orders(system, false)[1], 2.7);
  const Errors errors = errors_of(system, false);
  EXPECT_LE((errors.between.row(0) - 4. * errors.at_ends.row(0)).maxCoeff(), 0.);
}

TEST(DenseOutput, IsStraightWhereConsolidationBeginsWithAJump) {
  constexpr int nodes = 6;
  System system = consolidation(nodes, TimeFunction({0.}, {[](double) { return 0.; }, [](double) { return 1.; }}));
  system.readings = {position_reading("settlement", "m", "", {{0, 1.}})};
  const Series series = marched(system, 4, false, {0., 0.25, 0.5, 1.});
  EXPECT_EQ(series.reading(0, 0), 0.);
  EXPECT_NEAR(series.reading(0, 1), 0.25 * series.reading(0, 3), 1e-14);
  EXPECT_NEAR(series.reading(0, 2), 0.5 * series.reading(0, 3), 1e-14);
}

TEST(DenseOutput, HitsTheEndsOfTheSteps) {
  System system = sample_system({});
  system.loads = {sample_load(system, smooth())};
  read_free_unknowns(system);
  const auto scheme = make_scheme(system);
  const Series ends = march(system, *scheme, make_time_grid(kinks(system), end, end / 10.)).ends;
  const Series dense = marched(system, 10, true, ends.time);
  ASSERT_EQ(dense.time, ends.time);
  EXPECT_LE((dense.reading - ends.reading).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DenseOutput, StraightLinesAndTimesThatAreThere) {
  Series series{{0., 1., 3.}, Eigen::MatrixXd(1, 3), Eigen::MatrixXd(0, 3)};
  series.reading << 0., 2., 6.5;
  EXPECT_EQ(straight_between(series, {0., 0.5, 2., 3., 4.}).time, (std::vector<double>{0., 0.5, 2., 3.}));
  EXPECT_NEAR(straight_between(series, {0.5, 2.}).reading(0, 1), 4.25, 1e-15);
  EXPECT_EQ(at_times(series, {0.5, 1. + 1e-12, 3.}, 1e-9).reading, (Eigen::MatrixXd(1, 2) << 2., 6.5).finished());
}

}  // namespace dense_output_test
}  // namespace upbead::test
