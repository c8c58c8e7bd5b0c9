// Claim: where no water can flow, the pressure under a slow load is uniform, without oscillation from node to node,
// although the drained skin at the top, of millimetres, is far thinner than the cells, of decimetres.
// Source: tests/reference/ref9_stress.json, a (p/q = 1 / (1 + E/(alpha^2 Q)), statics).
// Limits: p 1e-4 of q away from the top row of cells; second differences of p from node to node 1e-3 of q in sum.

#include <gtest/gtest.h>

#include <cmath>

#include "stress_column.h"

namespace upbead::test {
namespace undrained_column_test {

/// Rises within T so smoothly (three zero derivatives at both ends) that a column with periods below T/20 does not
/// ring.
TimeFunction smooth_rise(double T) {
  const auto rise = [T](double t) {
    const double x = t / T;
    return x * x * x * x * (35. + x * (-84. + x * (70. - 20. * x)));
  };
  return TimeFunction({0., T}, {[](double) { return 0.; }, rise, [](double) { return 1.; }});
}

class Undrained : public ::testing::TestWithParam<std::tuple<std::string, int, bool>> {};

TEST_P(Undrained, PressureIsUniform) {
  const auto& [model, degree, inertia] = GetParam();
  const Json test = stress_case('a');
  const double height = test.at("L"), q = test.at("q"), rise = 0.5;
  Scene scene = stress_column(test, 1e-10, model, smooth_rise(rise));
  scene.time.inertia = inertia;
  const int cells = 40;
  for (int i = 0; i <= cells; ++i) scene.probes[std::to_string(i)].at = {0.5, height * i / cells};
  const ColumnRun run(scene, {even_lines(0., height, cells), degree, rise / 400.}, rise);
  std::vector<double> p;
  for (int i = 0; i < cells; ++i) p.push_back(run.at("probes/" + std::to_string(i) + "/pressure", {rise})[0] / q);
  double second_differences = 0.;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) second_differences += std::abs(p[i - 1] - 2. * p[i] + p[i + 1]);

  Record record("stress_undrained");
  const std::string name = model + ", degree " + std::to_string(degree) + (inertia ? "" : ", quasi-static") + ": ";
  const std::vector<double> exact(p.size(), test.at("static_p_over_q"));
  record.at_most(name + "p over q below the top row of cells", largest_error(p, exact, 1.), 1e-4);
  record.at_most(name + "sum of second differences of p over q", second_differences, 1e-3);
  const double u = run.at("probes/top/displacement_y", {rise})[0], u_exact = test.at("static_u_top");
  record.at_most(name + "settlement, relative", std::abs(u / u_exact - 1.), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Cases, Undrained,
                         ::testing::Values(std::make_tuple("upB", 2, true), std::make_tuple("upB", 3, true),
                                           std::make_tuple("full", 2, true), std::make_tuple("upB", 2, false)));

}  // namespace undrained_column_test
}  // namespace upbead::test
