// Claim: the static stiffness of a rigid strip bonded to a layer is right in all components, and that of the half-plane
// in rotation; a strip on a half-plane in plane strain has no static stiffness in sway and heave.
// Source: tests/reference/ref4_strip.json, `static`; half-plane: Muskhelishvili's bonded punch turned by a moment,
// K_rr = pi mu b^2 / (2 (1 - nu)) (1 + 4 eta^2), eta = ln(3 - 4 nu) / (2 pi). Limits: 0.5 % of each component, K_hr of
// sqrt(K_hh K_rr).

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "dynamic_stiffness.h"

namespace upbead::test {
namespace static_stiffness_test {

TEST(StaticStiffness, Layers) {
  Record record("strip_stiffness");
  for (const double nu : {0., 0.3, 0.45})
    for (const double depth : {1.5, 3.}) {
      const ElasticSoil soil{nu, depth};
      StiffnessCells cells;
      cells.calm = 12. * depth;  // past which the layer is still: motions die as exp(-pi x / (2 H)) or faster
      const Json table = compliance_entry(soil).at("static");
      Stiffness exact = Stiffness::Zero();
      exact(0, 0) = table.at("Khh").get<double>(), exact(1, 1) = table.at("Kv").get<double>();
      exact(2, 2) = table.at("Krr").get<double>(), exact(0, 2) = table.at("Khr").get<double>();
      record.at_most(name_of(soil) + ": static K_v, K_hh, K_rr, K_hr against the table",
                     stiffness_error(computed_stiffness(soil, cells, 0.), exact), 5e-3);
    }
}

TEST(StaticStiffness, RotationOnTheHalfPlane) {
  Record record("strip_stiffness");
  for (const double nu : {0., 0.3, 0.45}) {
    const ElasticSoil soil{nu};
    StiffnessCells cells;
    cells.calm = 1e4;  // a moment's motions die as 1/r
    const double eta = std::log(3. - 4. * nu) / (2. * M_PI);
    const double exact = 0.5 * M_PI / (1. - nu) * (1. + 4. * eta * eta);
    const Stiffness compliance = computed_stiffness(soil, cells, 0.).inverse();  // no horizontal force
    record.at_most(name_of(soil) + ": static K_rr under a moment alone against Muskhelishvili",
                   std::abs(1. / compliance(2, 2).real() / exact - 1.), 5e-3);
  }
}

}  // namespace static_stiffness_test
}  // namespace upbead::test
