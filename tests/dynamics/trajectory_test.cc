// Claims: between the ends of its steps a march is as accurate as at these ends, in x, x' and x'', with the loads
// themselves, also after a jump of a load; nearly as accurate without inertia and with a prescribed velocity. A reduced
// model answers at any time as if it had been asked at that time. Straight lines between rows meet the tolerance.
// Reference: a march in 4,000 steps whose ends include the times. Limits: orders, by regression; docs/theory.md.

#include "dynamics/trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sample_system.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead::test {
namespace trajectory_test {

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

Response marched(const System& system, int n, SchemeKind kind = SchemeKind::sdirk4) {
  const auto scheme = make_scheme(system, {kind});
  return march(system, *scheme, make_time_grid(kinks(system), end, end / n));
}

Series marched(const System& system, int n, const std::vector<double>& times) {
  const Response response = marched(system, n);
  return Trajectory(system, response).at(times);
}

Series reference(const System& system, const std::vector<double>& times) {
  std::vector<double> all = kinks(system);
  all.insert(all.end(), times.begin(), times.end());
  std::sort(all.begin(), all.end());
  const auto scheme = make_scheme(system);
  const Response response = march(system, *scheme, make_time_grid(all, end, end / 4000.));
  return Trajectory(system, response).at(times);
}

/// Largest errors by number of steps and reading: between the ends of the steps, and at them.
struct Errors {
  Eigen::MatrixXd between, at_ends;
};

Errors errors_of(const System& system, double from = 0.) {
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
        (marched(system, steps, times).reading - exact.reading).cwiseAbs().rowwise().maxCoeff();
    errors.at_ends.col(column++) =
        (marched(system, steps, ends).reading - exact_ends.reading).cwiseAbs().rowwise().maxCoeff();
  }
  return errors;
}

std::vector<double> orders(const System& system, double from = 0.) {
  const Errors errors = errors_of(system, from);
  std::vector<double> list;
  for (Eigen::Index r = 0; r < errors.between.rows(); ++r)
    list.push_back(order({20, 40, 80, 160},
                         {errors.between(r, 0), errors.between(r, 1), errors.between(r, 2), errors.between(r, 3)}));
  return list;
}

TEST(Trajectory, HasTheOrderOfTheScheme) {
  System system = sample_system({});
  system.loads = {sample_load(system, smooth())};
  read_free_unknowns(system);
  const std::vector<double> p = orders(system);
  EXPECT_GE(p[0], 3.8);
  EXPECT_GE(p[1], 3.8);
  EXPECT_GE(p[2], 2.8);  // x'' is computed from x and x' at the ends, whose error is h^4
  EXPECT_GE(p[3], 2.8);
  const Errors errors = errors_of(system);
  EXPECT_LE((errors.between.topRows(1) - 1.1 * errors.at_ends.topRows(1)).maxCoeff(), 0.);
}

TEST(Trajectory, HasItAfterAJump) {
  System system = sample_system({});
  system.loads = {sample_load(system, jump())};
  read_free_unknowns(system);
  const std::vector<double> p = orders(system);
  EXPECT_GE(p[0], 3.8);
  EXPECT_GE(p[1], 3.8);
  EXPECT_GE(p[2], 2.8);
}

TEST(Trajectory, FollowsAPrescribedVelocity) {
  Sample sample;
  sample.prescribed_u = true;
  System system = sample_system(sample);
  system.loads = {prescribed_load(system, smooth())};
  read_free_unknowns(system);
  const std::vector<double> p = orders(system);
  EXPECT_GE(p[0], 3.7);
  EXPECT_GE(p[1], 2.7);
}

TEST(Trajectory, OfConsolidationIsAboutAsGoodAsItsSteps) {
  constexpr int nodes = 6;
  System system = consolidation(nodes, smooth());
  system.readings = {position_reading("settlement", "m", "", {{0, 1.}}),
                     velocity_reading("pressure", "Pa", "", {{2 * nodes - 1, 1.}})};
  EXPECT_GE(orders(system)[1], 2.7);
  const Errors errors = errors_of(system);
  EXPECT_LE((errors.between.row(0) - 4. * errors.at_ends.row(0)).maxCoeff(), 0.);
}

TEST(Trajectory, IsStraightWhereConsolidationBeginsWithAJump) {
  constexpr int nodes = 6;
  System system = consolidation(nodes, TimeFunction({0.}, {[](double) { return 0.; }, [](double) { return 1.; }}));
  system.readings = {position_reading("settlement", "m", "", {{0, 1.}})};
  const Series series = marched(system, 4, {0., 0.25, 0.5, 1.});
  EXPECT_EQ(series.reading(0, 0), 0.);
  EXPECT_NEAR(series.reading(0, 1), 0.25 * series.reading(0, 3), 1e-14);
  EXPECT_NEAR(series.reading(0, 2), 0.5 * series.reading(0, 3), 1e-14);
}

TEST(Trajectory, HitsTheEndsOfTheSteps) {
  System system = sample_system({});
  system.loads = {sample_load(system, smooth())};
  read_free_unknowns(system);
  const Response response = marched(system, 10);
  const Series at_ends = Trajectory(system, response).at(response.ends.time);
  EXPECT_EQ(at_ends.time, response.ends.time);
  EXPECT_EQ(at_ends.reading, response.ends.reading);
  std::vector<double> beside;
  for (std::size_t i = 1; i < response.ends.time.size(); ++i) beside.push_back(response.ends.time[i] - 1e-6);
  const Eigen::MatrixXd apart = Trajectory(system, response).at(beside).reading - response.ends.reading.rightCols(10);
  EXPECT_LE(apart.cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Trajectory, IsStraightWhereASchemeKnowsNoMore) {
  const System system = oscillator(1., 0.2, 3., smooth());
  const Response response = marched(system, 10, SchemeKind::generalised_alpha);
  const Trajectory trajectory(system, response);
  const Eigen::MatrixXd& ends = response.ends.reading;
  const Series found = trajectory.at({0.1, 0.4, end + 1.});
  EXPECT_EQ(found.time, (std::vector<double>{0.1, 0.4}));
  EXPECT_NEAR(found.reading(0, 0), 0.75 * ends(0, 0) + 0.25 * ends(0, 1), 1e-15);
  EXPECT_EQ(found.reading(0, 1), ends(0, 1));
  const Rows rows = trajectory.rows({0}, 1e-3, 1000);
  EXPECT_EQ(rows.time, response.ends.time);
  EXPECT_LT(rows.error, 0.);
}

/// Largest difference of each reading at odd times from straight lines between the rows, over its largest value.
double off_lines(const Trajectory& trajectory, const std::vector<double>& rows) {
  const Series known = trajectory.at(rows);
  const Eigen::VectorXd largest = known.reading.cwiseAbs().rowwise().maxCoeff();
  double worst = 0.;
  std::vector<double> times;
  for (int i = 0; i < 4999; ++i) times.push_back(end * (i + 0.43) / 5000.);
  const Series exact = trajectory.at(times);
  std::size_t right = 1;
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (rows[right] < times[i]) ++right;
    const double s = (times[i] - rows[right - 1]) / (rows[right] - rows[right - 1]);
    const auto r = static_cast<Eigen::Index>(right);
    const Eigen::VectorXd line = (1. - s) * known.reading.col(r - 1) + s * known.reading.col(r);
    worst = std::max(
        worst, ((exact.reading.col(static_cast<Eigen::Index>(i)) - line).cwiseQuotient(largest)).cwiseAbs().maxCoeff());
  }
  return worst;
}

TEST(Trajectory, StraightLinesBetweenRowsMeetTheTolerance) {
  for (const TimeFunction& load : {smooth(), jump()}) {
    System system = sample_system({});
    system.loads = {sample_load(system, load)};
    read_free_unknowns(system);
    const Response response = marched(system, 20);
    const Trajectory trajectory(system, response);
    EXPECT_GT(off_lines(trajectory, response.ends.time), 0.01);
    std::size_t before = response.ends.time.size();
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      const Rows rows = trajectory.rows({0, 1, 2, 3}, tolerance, 20000);
      EXPECT_LE(rows.error, tolerance);
      EXPECT_LE(off_lines(trajectory, rows.time), 1.1 * tolerance);
      EXPECT_TRUE(
          std::includes(rows.time.begin(), rows.time.end(), response.ends.time.begin(), response.ends.time.end()));
      EXPECT_GT(rows.time.size(), before);
      EXPECT_LT(rows.time.size(), 5 * before);
      before = rows.time.size();
    }
    const Rows few = trajectory.rows({0, 1, 2, 3}, 1e-4, 100);
    EXPECT_LE(few.time.size(), 100U);
    EXPECT_GT(few.error, 1e-4);
    EXPECT_NEAR(off_lines(trajectory, few.time), few.error, 0.1 * few.error);
  }
}

TEST(Trajectory, OfAReducedModelIsThatOfItsLoads) {
  // x = Re z of one mode with the reading's load let through: two more than the system has
  ModalModel model;
  model.reading_label = {{"x", "m", ""}, {"hidden", "m", ""}};
  model.load_name = {"push"};
  model.pole = Eigen::VectorXcd::Constant(1, std::complex<double>(-0.3, 5.));
  model.reading = Eigen::MatrixXcd::Constant(2, 1, std::complex<double>(0.2, -1.));
  model.load = Eigen::MatrixXcd::Constant(1, 1, std::complex<double>(1., 0.5));
  model.feedthrough = Eigen::MatrixXd::Constant(2, 1, 0.7);
  model.impulse = Eigen::MatrixXd::Constant(2, 1, 0.1);
  const System system = oscillator(1., 0.2, 3., jump());
  Response response;
  std::vector<double> time, finer;
  for (int i = 0; i <= 20; ++i) time.push_back(end * i / 20.);
  response.ends = respond(model, sample(load_histories(system), time));
  response.ends.reading.conservativeResize(1, Eigen::NoChange);
  const Trajectory trajectory(system, response, &model);
  EXPECT_EQ(trajectory.at(time).reading, response.ends.reading);
  const Rows rows = trajectory.rows({0}, 1e-3, 20000);
  EXPECT_LE(rows.error, 1e-3);
  EXPECT_EQ(rows.time[1], rows.time[0] + 1e-6 * end / 20.) << "after the jump of the load";
  EXPECT_LE(off_lines(trajectory, rows.time), 1.1e-3);
  // piece by piece is the same as all at once, but for steps that respond() takes as equal within 1e-9 of a step
  const Series whole = trajectory.at(rows.time);
  for (std::size_t i = 3; i < rows.time.size(); i += 17)
    EXPECT_NEAR(trajectory.at({rows.time[i]}).reading(0, 0), whole.reading(0, static_cast<Eigen::Index>(i)), 1e-10);
}

}  // namespace trajectory_test
}  // namespace upbead::test
