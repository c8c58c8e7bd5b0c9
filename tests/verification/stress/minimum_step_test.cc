// Claim: steps far too short for the cells cause no overshoot. If the pressure is fixed at the nodes of a drained
// side, the first step after a sudden load overshoots by a quarter (table); if it is imposed weakly, it does not.
// Source: tests/reference/ref9_stress.json, c (Vermeer and Verruijt 1981: c_v dt / h^2 >= 1/6).
// Limits, after one step and after four at c_v dt / h^2 = 0.001: overshoot 1 % of p_0; p two cells from the drained
// side within 5 % of p_0.

#include <gtest/gtest.h>

#include <algorithm>

#include "stress_column.h"

namespace upbead::test {
namespace minimum_step_test {

constexpr double height = 10.;  // m
constexpr int cells = 40;

struct Extremes {
  double largest = 0.;  ///< p / p_0 anywhere
  double least = 2.;    ///< p / p_0 two cells and more below the drained side
};

/// Extremes of p / p_0 at nodes and middles of cells after `steps` steps of ratio h^2 / c_v.
Extremes march_column(int degree, SchemeKind scheme, double ratio, int steps) {
  const Json test = stress_case('a');
  Scene scene = stress_column(test, 1e-4, "upB", step_load(1.));
  scene.time.inertia = false;
  scene.mesh.degree = degree;
  for (int i = 0; i <= 2 * cells; ++i) scene.probes[std::to_string(i)].at = {0.5, 0.5 * height * i / cells};
  const Material m = material(scene.regions.at("soil"), scene.fluid, scene.gravity);
  const double compliance = 1. / (m.lambda + 2. * m.G) + m.storage, h = height / cells;
  const double c_v = 1. / (m.b * compliance), dt = ratio * h * h / c_v;
  const double p_0 = test.at("q").get<double>() / (m.lambda + 2. * m.G) / compliance;

  const auto mesh = column_mesh(height, cells);
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, steps * dt, dt, scheme);
  Extremes found;
  for (int i = 0; i <= 2 * cells; ++i) {
    const double p = history(compiled, response, "probes/" + std::to_string(i) + "/pressure").tail<1>()[0] / p_0;
    found.largest = std::max(found.largest, p);
    if (i <= 2 * (cells - 2)) found.least = std::min(found.least, p);
  }
  return found;
}

class MinimumStep : public ::testing::TestWithParam<std::tuple<int, SchemeKind>> {};

TEST_P(MinimumStep, DoesNotOvershoot) {
  const auto [degree, scheme] = GetParam();
  Record record("stress_step");
  const std::string name = std::string(scheme == SchemeKind::sdirk4 ? "sdirk4" : "generalised_alpha") +
                           ", degree of p " + std::to_string(degree - 1);
  for (const int steps : {1, 4}) {
    const Extremes found = march_column(degree, scheme, 1e-3, steps);
    const std::string when = name + ", after " + std::to_string(steps) + (steps == 1 ? " step: " : " steps: ");
    record.at_most(when + "p above p_0, over p_0", found.largest - 1., 0.01);
    record.at_most(when + "p two cells from the drained side below p_0, over p_0", 1. - found.least, 0.05);
  }
  Curve curve{
      "degree of p " + std::to_string(degree - 1),
      "c_v dt / h^2 (log)",
      "largest p / p_0",
      scheme == SchemeKind::sdirk4 ? "line: fixed at the nodes (table); dots: sdirk4" : "dots: generalised_alpha",
      {},
      {},
      {}};
  const Json test = stress_case('c');
  for (const Json& row : test.at("table")) {
    if (row.at("order") != degree - 1) continue;
    curve.abscissa.push_back(row.at("c_dt_over_h2"));
    curve.exact.push_back(row.at("max_p_over_p0"));
    curve.computed.push_back(march_column(degree, scheme, curve.abscissa.back(), 1).largest);
  }
  record.curve(curve);
}

INSTANTIATE_TEST_SUITE_P(Cases, MinimumStep,
                         ::testing::Combine(::testing::Values(2, 3),
                                            ::testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha)));

}  // namespace minimum_step_test
}  // namespace upbead::test
