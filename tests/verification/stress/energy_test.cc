// Claim: the balance of energy closes. Under a lasting load half of the work is stored in the end and drag dissipates
// the other half, with either flow; under a pulse drag dissipates all of the work; no energy is lost or gained in 1e5
// steps. Source: tests/reference/ref9_stress.json, h (work from the exact solution; q^2 L / E and its half). Limits:
// 1e-9 of the work for the balance at every step; 1e-3 for the work and for the energy taken by drag, which the
// scheme's own dissipation reduces.

#include <gtest/gtest.h>

#include <cmath>

#include "stress_column.h"

namespace upbead::test {
namespace energy_test {

double largest_mismatch(const Response& response) {
  double largest = 0.;
  for (const EnergyAccount& energy : response.energy) largest = std::max(largest, energy.mismatch());
  return largest;
}

class Energy : public ::testing::TestWithParam<std::string> {};

TEST_P(Energy, OfALastingLoadIsHalfStoredHalfDissipated) {
  const Json test = stress_case('h'), exact = test.at("step_load");
  const Scene scene = stress_column(test, test.at("k"), GetParam(), step_load(1.));
  const ColumnRun run(scene, {geometric_lines(test.at("L"), 40, 10.), 2, 4e-3}, 20.);
  const EnergyAccount& energy = run.response().energy.back();
  Record record("stress_energy");
  const std::string name = "step load, " + GetParam() + ": ";
  record.at_most(name + "balance at any step over the work", largest_mismatch(run.response()), 1e-9);
  record.at_most(name + "work at the end, relative",
                 std::abs(energy.work / exact.at("external_work_total").get<double>() - 1.), 1e-3);
  record.at_most(name + "stored at the end, relative",
                 std::abs((energy.strain + energy.fluid + energy.kinetic) / exact.at("stored").get<double>() - 1.),
                 1e-3);
  record.at_most(name + "taken by drag and scheme, relative",
                 std::abs((energy.drag + energy.scheme) / exact.at("dissipated").get<double>() - 1.), 1e-3);
  record.measured(name + "part of the work that the scheme takes", energy.scheme / energy.work);
}

TEST_P(Energy, OfAPulseIsTakenByDrag) {
  const Json test = stress_case('h'), exact = test.at("triangle_td_0p1");
  const Scene scene = stress_column(test, test.at("k"), GetParam(), triangle(1., 0.1));
  const ColumnRun run(scene, {geometric_lines(test.at("L"), 40, 10.), 2, 1e-3}, 4.);
  const EnergyAccount& energy = run.response().energy.back();
  const double work = exact.at("external_work").at(GetParam());
  Record record("stress_energy");
  const std::string name = "triangle of 0.1 s, " + GetParam() + ": ";
  record.at_most(name + "balance at any step over the work", largest_mismatch(run.response()), 1e-9);
  record.at_most(name + "work, relative", std::abs(energy.work / work - 1.), 1e-3);
  record.at_most(name + "taken by drag, relative to the work", std::abs(energy.drag / work - 1.), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Models, Energy, ::testing::Values("full", "upB"));

TEST(LongRun, NothingGrowsInAHundredThousandSteps) {
  const Json test = stress_case('h');
  Pulse pulse;
  pulse.shape = PulseShape::harmonic;
  pulse.peak = 1.;
  pulse.frequency = 2.;
  const Scene scene = stress_column(test, test.at("k"), "full", time_function(pulse));
  const ColumnRun run(scene, {even_lines(0., test.at("L"), 4), 2, 0.01}, 1000.);
  const auto u = history(run.compiled(), run.response(), "probes/top/displacement_y");
  ASSERT_GE(run.response().n_steps, 100000);
  const double early = u.segment(2000, 1000).cwiseAbs().maxCoeff(), late = u.tail(1000).cwiseAbs().maxCoeff();
  Record record("stress_energy");
  record.at_most("1e5 steps under a harmonic load: change of the amplitude, relative", std::abs(late / early - 1.),
                 1e-9);
  record.at_most("1e5 steps: balance at any step over the work", largest_mismatch(run.response()), 1e-9);
}

}  // namespace energy_test
}  // namespace upbead::test
