// Claim: the dynamic stiffness of a rigid massless strip bonded to elastic soil is right at every frequency from
// a0 = 0.1 to 5, radiation included: the program's own M, C and K with i a0 in place of d/dt.
// Source: our own semi-analytical computation (strip_theory.h), and tests/reference/ref4_strip.json, `compliance`,
// `bonded`. A scene cannot describe a strip that slides freely on the soil (`relaxed`). The table is wrong below a0 =
// 0.5 on the half-plane and above the first cut-off frequency of a layer, where theory and program agree with each
// other and not with the table; its error is recorded with the checks. Limits: 0.5 % of each component's magnitude,
// K_hr of sqrt(|K_hh| |K_rr|), also near resonances, where a stiffness is nearly zero. Here one half-plane and one
// layer; the other soils are in dynamic_stiffness_long_test.cc.

#include <gtest/gtest.h>

#include "dynamic_stiffness.h"

namespace upbead::test {
namespace dynamic_stiffness_test {

TEST(DynamicStiffness, HalfPlaneAtLength) {
  compare_dynamic_stiffness({0.3}, true);
}

TEST(DynamicStiffness, Layer) {
  compare_dynamic_stiffness({0.3, 1.5}, true);
}

// Reflections by the rings would appear as a change of the stiffness when the rings begin farther away, are damped
// differently or are shorter.
TEST(DynamicStiffness, RingsReflectLittleAtLength) {
  Record record("strip_stiffness");
  for (const double a0 : {0.1, 2.}) {
    const ElasticSoil soil{0.3};
    StiffnessCells cells = cells_for(soil, a0);
    const Stiffness K = computed_stiffness(soil, cells, a0);
    cells.calm *= 2.;
    cells.damping *= 0.75;
    record.at_most(
        name_of(soil) + ", a0 = " + Json(a0).dump() + ": change of K with the absorbing rings moved and weakened",
        stiffness_error(computed_stiffness(soil, cells, a0), K), 1e-3);
  }
  const ElasticSoil layer{0.3, 1.5};
  StiffnessCells cells = cells_for(layer, 2.);  // 2 % above the cut-off frequency of pressure waves
  const Stiffness K = computed_stiffness(layer, cells, 2.);
  cells.rings *= 0.75;
  cells.damping *= 1.5;
  record.at_most(name_of(layer) + ", a0 = 2: change of K with absorbing rings shorter by a quarter",
                 stiffness_error(computed_stiffness(layer, cells, 2.), K), 1e-3);
}

}  // namespace dynamic_stiffness_test
}  // namespace upbead::test
