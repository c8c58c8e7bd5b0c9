// Claims: all readings are written at exactly the times that a case lists, by a march and by a reduced model, and so
// are fields; histories at equal times are those of a march in far shorter steps; steps of a consolidation grow by
// the factor that the case gives. Reference: the same case in other steps.

#include <algorithm>
#include <cmath>

#include "case/case_run.h"
#include "fem/compile.h"
#include "findings/histories.h"
#include "good_case.h"
#include "response/time_choice.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"

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
  const auto row = run.simulation->compiled->system.reading("shear_force");
  return (a.reading.row(row) - b.reading.row(row)).cwiseAbs().maxCoeff() / b.reading.row(row).cwiseAbs().maxCoeff();
}

const std::vector<double> asked{0.033, 0.0751, 0.3, 0.6};
const std::string times = "output.times=[0.033, 0.0751, 0.3, 0.6]";

TEST_F(ChosenTimes, AreTheReadingsOfAFineMarch) {
  const upbead::Run fine = solved({times, "time={ end = 0.6, step = 0.0005, scheme = \"sdirk4\" }"});
  ASSERT_EQ(fine.at_times->time, asked);
  for (const char* time :
       {"time={ end = 0.6, step = 0.004, scheme = \"sdirk4\" }", "time={ end = 0.6, scheme = \"reduced\" }"}) {
    const upbead::Run run = solved({times, time});
    ASSERT_TRUE(run.at_times) << time;
    EXPECT_EQ(run.at_times->time, asked) << time;
    EXPECT_FALSE(run.dense);
    EXPECT_LE(shear_difference(run, *run.at_times, *fine.at_times), 3e-3) << time;
    const std::string csv = times_csv(run);
    EXPECT_EQ(csv.substr(0, 22), "time (s),force (N/m),f") << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  }
}

TEST_F(ChosenTimes, DenseHistoriesAreThoseOfAFineMarchAtLength) {
  const std::string every = "output.every=0.0013";
  const upbead::Run fine = solved({every, "time={ end = 0.6, step = 0.0005, scheme = \"sdirk4\" }"});
  ASSERT_EQ(fine.dense->time.size(), 462U);
  EXPECT_EQ(fine.dense->time[0], 0.);
  EXPECT_EQ(fine.dense->reading.col(0).cwiseAbs().maxCoeff(), 0.);
  for (const auto& [time, limit] :
       {std::pair("time={ end = 0.6, step = 0.006, scheme = \"sdirk4\" }", 1e-2),
        std::pair("time={ end = 0.6, step = 0.003, scheme = \"sdirk4\" }", 2e-3),
        std::pair("time={ end = 0.6, scheme = \"reduced\" }", 1e-2),
        std::pair("time={ end = 0.6, step = 0.001, scheme = \"generalised_alpha\" }", 1e-2)}) {
    const upbead::Run run = solved({every, time});
    ASSERT_EQ(run.dense->time, fine.dense->time);
    EXPECT_LE(shear_difference(run, *run.dense, *fine.dense), limit) << time;
  }
}

TEST_F(ChosenTimes, OfContactAreThoseOfItsSteps) {
  const upbead::Run run = solved({"output={ every = 0.01, times = [0.05, 0.3] }", "initial.water_level=15",
                                  "regions.caisson.interface.kind=friction", "time.end=0.4"});
  ASSERT_TRUE(run.summary.contact);
  EXPECT_EQ(run.at_times->time, (std::vector<double>{0.05, 0.3}));
  EXPECT_EQ(run.dense->reading.rows(), run.response.ends.reading.rows());
  EXPECT_EQ(run.dense->time.size(), 41U);
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
    const auto row = run.simulation->compiled->system.reading("caisson/rotation");
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
