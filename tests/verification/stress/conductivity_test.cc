// Claim: the same scheme is right from soil that is nearly impermeable (k = 1e-10 m/s) to soil with nearly no
// resistance to flow (1e3 m/s), with inertial and darcy flow.
// Source: tests/reference/ref9_stress.json, g (Laplace transform inverted numerically): a ramp of 50 ms, then constant.
// Limits: u at the top 0.2 % and p at the base 1 % of their largest values over the sweep's row.

#include <gtest/gtest.h>

#include "stress_column.h"

namespace upbead::test {
namespace conductivity_test {

class Conductivity : public ::testing::TestWithParam<unsigned> {};

TEST_P(Conductivity, Column) {
  const Json test = stress_case('g'), row = test.at("rows").at(GetParam());
  const std::vector<double> t = test.at("t");
  const double k = row.at("k"), height = test.at("L");
  Record record("stress_conductivity");
  for (const std::string model : {"full", "upB"}) {
    const Scene scene = stress_column(test, k, model, step_load(1., 0.05));
    const ColumnRun run(scene, {geometric_lines(height, 80, k < 1e-8 ? 2000. : 20.), 3, 2e-4}, t.back());
    const std::string name = "k = " + row.at("k").dump() + " m/s, " + model + ": ";
    const double q = test.at("q");
    record.at_most(name + "u at the top over its largest value",
                   largest_error(run.at("probes/top/displacement_y", t), row.at(model).at("u_top")), 2e-3);
    record.at_most(name + "p at the base over q",
                   largest_error(run.at("probes/base/pressure", t), row.at(model).at("p_base"), q), 1e-2);
  }
}

/// Both ends of the sweep and its middle.
INSTANTIATE_TEST_SUITE_P(Rows, Conductivity, ::testing::Values(0u, 4u, 8u));
INSTANTIATE_TEST_SUITE_P(RowsAtLength, Conductivity, ::testing::Values(1u, 2u, 3u, 5u, 6u, 7u));

}  // namespace conductivity_test
}  // namespace upbead::test
