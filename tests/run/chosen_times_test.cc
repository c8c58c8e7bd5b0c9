// Claims: all readings are written at exactly the times that a case lists, by a march and by a reduced model, and so
// are fields; histories at equal times are those of a march in far shorter steps; straight lines between the rows of
// /history follow F_T within the tolerance of its peak, by a march and by a reduced model, of damped and undamped
// ground, also where a load jumps and without inertia; steps of a consolidation grow by the factor that the case gives.
// Reference: the same case in other steps.

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "findings/histories.h"
#include "good_case.h"
#include "response/time_choice.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace chosen_times_test {

class ChosenTimes : public InFolder {
 protected:
  ChosenTimes() {
    unsetenv("UPBEAD_MESHES");
    write("case.toml", section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.5"}}));
  }

  static upbead::Run solved(const std::vector<std::string>& overrides) {
    static const PetscSession petsc;
    const Case input = read_case("case.toml", overrides);
    return simulation_of(input).run();
  }
};

/// Largest difference of F_T over its largest value.
double shear_difference(const upbead::Run& run, const Series& a, const Series& b) {
  const auto row = run.simulation->system().reading("shear_force");
  return (a.reading.row(row) - b.reading.row(row)).cwiseAbs().maxCoeff() / b.reading.row(row).cwiseAbs().maxCoeff();
}

Dataset table(const upbead::Run& run, const std::string& name) {
  for (Dataset& found : tables(run))
    if (found.name == name) return found;
  throw std::out_of_range(name);
}

/// Largest difference of straight lines between the rows of F_T of a run from its values at other times, over the peak.
double off_lines(const upbead::Run& run, const std::vector<double>& at, const std::vector<double>& exact) {
  const std::vector<double> t = table(run, "history/time").values, F_T = table(run, "history/shear_force").values;
  double worst = 0., peak = 0.;
  std::size_t right = 1;
  for (std::size_t i = 0; i < at.size(); ++i) {
    while (t[right] < at[i] && right + 1 < t.size()) ++right;
    const double s = (at[i] - t[right - 1]) / (t[right] - t[right - 1]);
    worst = std::max(worst, std::abs((1. - s) * F_T[right - 1] + s * F_T[right] - exact[i]));
    peak = std::max(peak, std::abs(exact[i]));
  }
  return worst / peak;
}

const std::vector<double> asked{0.033, 0.0751, 0.3, 0.6};
const std::string times = "output.times=[0.033, 0.0751, 0.3, 0.6]";

TEST_F(ChosenTimes, AreTheReadingsOfAFineMarch) {
  const upbead::Run fine = solved({times, "time={ end = 0.6, step = 0.0005, scheme = \"sdirk4\" }"});
  const Series exact = trajectory_of(fine).at(asked);
  ASSERT_EQ(exact.time, asked);
  for (const char* time :
       {"time={ end = 0.6, step = 0.004, scheme = \"sdirk4\" }", "time={ end = 0.6, scheme = \"reduced\" }"}) {
    const upbead::Run run = solved({times, time});
    EXPECT_EQ(table(run, "at_times/time").values, asked) << time;
    EXPECT_LE(shear_difference(run, trajectory_of(run).at(asked), exact), 3e-3) << time;
    const std::string csv = times_csv(run);
    EXPECT_EQ(csv.substr(0, 22), "time (s),force (N/m),f") << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  }
}

TEST_F(ChosenTimes, DenseHistoriesAreThoseOfAFineMarchAtLength) {
  const std::string every = "output.every=0.0013";
  const upbead::Run fine = solved({every, "time={ end = 0.6, step = 0.0005, scheme = \"sdirk4\" }"});
  const std::vector<double> equal = table(fine, "dense/time").values;
  ASSERT_EQ(equal.size(), 462U);
  const Series exact = trajectory_of(fine).at(equal);
  EXPECT_EQ(exact.time[0], 0.);
  EXPECT_EQ(exact.reading.col(0).cwiseAbs().maxCoeff(), 0.);
  for (const auto& [time, limit] :
       {std::pair("time={ end = 0.6, step = 0.006, scheme = \"sdirk4\" }", 1e-2),
        std::pair("time={ end = 0.6, step = 0.003, scheme = \"sdirk4\" }", 2e-3),
        std::pair("time={ end = 0.6, scheme = \"reduced\" }", 1e-2),
        std::pair("time={ end = 0.6, step = 0.001, scheme = \"generalised_alpha\" }", 1e-2)}) {
    const upbead::Run run = solved({every, time});
    ASSERT_EQ(table(run, "dense/time").values, equal);
    EXPECT_LE(shear_difference(run, trajectory_of(run).at(equal), exact), limit) << time;
  }
}

/// By a run in steps a 20th as long, or, where that has another answer, by the run's own trajectory.
void expect_rows_meet_the_tolerance(const std::function<upbead::Run(const std::vector<std::string>&)>& solved,
                                    const std::string& key, const std::string& scheme, double end, double step,
                                    bool by_itself = false) {
  const auto in_steps = [&](double h) {
    return solved({key, "accuracy.tolerance=0.001",
                   "time={ end = " + std::to_string(end) + ", step = " + std::to_string(h) + ", " + scheme + " }"});
  };
  const upbead::Run run = in_steps(step);
  const std::string told = scheme + ", " + key;
  EXPECT_NE(table(run, "history/time").description.find("err by at most 0.0"), std::string::npos) << told;
  EXPECT_GT(table(run, "history/time").values.size(), run.response.ends.time.size()) << told;
  if (by_itself) {
    std::vector<double> times;
    for (double t = 0.; t < end; t += step / 91.) times.push_back(t);
    const auto row = run.simulation->system().reading("shear_force");
    const Eigen::RowVectorXd F_T = trajectory_of(run).at(times).reading.row(row);
    EXPECT_LT(off_lines(run, times, {F_T.begin(), F_T.end()}), 1e-3) << told;
  } else {
    const upbead::Run fine = in_steps(step / 20.);
    EXPECT_LT(off_lines(run, table(fine, "history/time").values, table(fine, "history/shear_force").values), 1e-3)
        << told;
  }
}

TEST_F(ChosenTimes, RowsOfHistoriesMeetTheToleranceAtLength) {
  const std::string marched = "scheme = \"sdirk4\"", reduced = "scheme = \"reduced\"",
                    undamped = "regions.seabed.damping={ ratio = 0.0, frequencies = [2.0, 20.0] }",
                    jump = "loads.impulse.pulse={ shape = \"step\", peak = 1e6 }",
                    ramp = "loads.impulse.pulse={ shape = \"step\", peak = 1e6, rise = 5.0 }";
  expect_rows_meet_the_tolerance(solved, "title=damped", marched, 0.3, 0.003);
  expect_rows_meet_the_tolerance(solved, "title=damped", reduced, 0.6, 0.01);
  expect_rows_meet_the_tolerance(solved, jump, reduced, 0.6, 0.01);
  expect_rows_meet_the_tolerance(solved, undamped, reduced, 0.6, 0.01);
  expect_rows_meet_the_tolerance(solved, jump, marched, 0.3, 0.001);
  expect_rows_meet_the_tolerance(solved, ramp, marched + ", inertia = false", 20., 0.5, true);
}

TEST_F(ChosenTimes, OfContactAreThoseOfItsSteps) {
  const upbead::Run run = solved({"output={ every = 0.01, times = [0.05, 0.3] }", "initial.water_level=15",
                                  "regions.caisson.interface.kind=friction", "time.end=0.4", "loads.impulse.factor=3"});
  ASSERT_TRUE(run.contact);
  EXPECT_EQ(table(run, "at_times/time").values, (std::vector<double>{0.05, 0.3}));
  EXPECT_EQ(table(run, "dense/time").values.size(), 41U);
  EXPECT_EQ(table(run, "history/time").values, run.response.ends.time);
  EXPECT_NE(table(run, "history/time").description.find("the ends of the steps"), std::string::npos);
}

TEST_F(ChosenTimes, GrowthOfStepsIsTheCases) {
  const std::string drained = "time={ end = 1e4, inertia = false, growth = ";
  std::vector<double> settled, steps;
  for (const char* growth : {"1.5", "2.0", "3.0"}) {
    const upbead::Run run =
        solved({drained + growth + " }", "loads.impulse.pulse={ shape = \"step\", peak = 1e6, rise = 50.0 }"});
    const std::vector<double>& t = run.response.ends.time;
    double largest = 1.;
    for (std::size_t i = 2; i < t.size(); ++i) largest = std::max(largest, (t[i] - t[i - 1]) / (t[i - 1] - t[i - 2]));
    EXPECT_NEAR(largest, std::stod(growth), 1e-6);
    steps.push_back(run.response.n_steps);
    const auto row = run.simulation->system().reading("caisson/rotation");
    settled.push_back(run.response.ends.reading.row(row).tail<1>()[0]);
  }
  EXPECT_GT(steps[0], steps[1]);
  EXPECT_GT(steps[1], steps[2]);
  for (const double value : settled) EXPECT_NEAR(value, settled[0], 1e-4 * std::abs(settled[0]));
  const Case equal = read_case("case.toml", {drained + "1 }"});
  EXPECT_FALSE(step_of_loads(equal.scene, 4).growth);
}

}  // namespace chosen_times_test
}  // namespace upbead::test
