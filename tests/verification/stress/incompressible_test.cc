// Claim: as the water grows stiffer the result converges, like 1/K_f, to that of incompressible water, which the same
// steps can solve, too.
// Source: tests/reference/ref9_stress.json, f (Laplace transform inverted numerically): a triangle of 100 ms.
// Limits: u 0.2 % of the largest settlement, p 1 % of q; order of convergence in 1/K_f within 10 % of 1.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stress_column.h"

namespace upbead::test {
namespace incompressible_test {

struct Found {
  double settlement = 0., u_at_end = 0., p_at_peak = 0.;
};

Found march_column(const Json& test, const std::string& model, double K_f) {
  const double td = test.at("td");
  Scene scene = stress_column(test, test.at("k"), model, triangle(1., td));
  scene.fluid.bulk_modulus = K_f;
  const ColumnRun run(scene, {geometric_lines(test.at("L"), 60, 10.), 3, td / 500.}, 2. * td);
  const auto u = history(run.compiled(), run.response(), "probes/top/displacement_y");
  return {-u.minCoeff(), run.at("probes/top/displacement_y", {td})[0], run.at("probes/base/pressure", {0.5 * td})[0]};
}

class Incompressible : public ::testing::TestWithParam<std::string> {};

TEST_P(Incompressible, IsTheLimit) {
  const std::string model = GetParam();
  const Json test = stress_case('f');
  Record record("stress_incompressible");
  std::vector<double> compressibility, settlement;
  for (const Json& row : test.at("rows")) {
    const Json& exact = row.at(model);
    const double K_f = row.at("Kf"), largest = exact.at("max_settlement"), q = test.at("q");
    const Found found = march_column(test, model, K_f);
    const std::string name = "K_f = " + row.at("Kf").dump() + " Pa, " + model + ": ";
    record.at_most(name + "largest settlement, relative", std::abs(found.settlement / largest - 1.), 2e-3);
    record.at_most(name + "u at 0.1 s over the largest settlement",
                   std::abs(found.u_at_end - exact.at("u_at_0p1").get<double>()) / largest, 2e-3);
    record.at_most(name + "p at the base at 0.05 s over q",
                   std::abs(found.p_at_peak - exact.at("p_base_at_0p05").get<double>()) / q, 1e-2);
    compressibility.push_back(1. / K_f);
    settlement.push_back(found.settlement);
  }
  const double limit = march_column(test, model, std::numeric_limits<double>::infinity()).settlement;
  std::vector<double> distance;
  for (double& value : settlement) distance.push_back(std::abs(value - limit));
  // The softest two fluids are far from the limit.
  const double rate =
      order({compressibility.begin() + 2, compressibility.end()}, {distance.begin() + 2, distance.end()});
  record.at_most("order in 1/K_f of the distance from K_f = inf, " + model + ": difference from 1", std::abs(rate - 1.),
                 0.1);
}

INSTANTIATE_TEST_SUITE_P(Models, Incompressible, ::testing::Values("upB"));
INSTANTIATE_TEST_SUITE_P(ModelsAtLength, Incompressible, ::testing::Values("full"));

}  // namespace incompressible_test
}  // namespace upbead::test
