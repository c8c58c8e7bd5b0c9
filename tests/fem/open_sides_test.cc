// Claims: the weak condition on open sides is consistent (a uniform pressure prescribed by a load causes no flow, by
// Darcy's or inertial flow), it lets a drained column consolidate to the end, and it keeps the system well posed with
// incompressible water on the mound's distorted cells. Source: docs/theory.md, open sides. Tolerance: round-off.

#include <gtest/gtest.h>

#include "scenes.h"

namespace upbead::test {
namespace open_sides_test {

class OpenSides : public ::testing::TestWithParam<std::tuple<Flow, int>> {};

TEST_P(OpenSides, UniformPrescribedPressureFlowsNowhere) {
  const auto [flow, degree] = GetParam();
  Region soil = rubble();
  soil.flow = flow;
  soil.biot = 0.;  // the pressure then exerts no force on the skeleton
  Scene scene = column(soil, triangle(1., 0.1));
  scene.loads["top"].kind = LoadKind::pressure;
  scene.loads["top"].direction = {1., 0.};
  scene.mesh.degree = degree;
  const auto mesh = column_mesh(5., 8);
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  ASSERT_EQ(system.n_prescribed, 1);
  Vector pressure = Vector::Zero(system.size());
  for (int i = 0; i < system.size(); ++i)
    if (system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse) pressure[i] = 1.;
  const double flows = (system.C * pressure).norm();
  pressure[system.size() - 1] = 0.;  // with the pressure in the soil only, water flows out
  EXPECT_LE(flows, 1e-11 * (system.C * pressure).norm());
}

INSTANTIATE_TEST_SUITE_P(Flows, OpenSides,
                         ::testing::Combine(::testing::Values(Flow::darcy, Flow::inertial), ::testing::Values(2, 3)));

TEST(OpenSides, IncompressibleWaterIsWellPosed) {
  for (const Flow flow : {Flow::darcy, Flow::inertial})
    for (const int degree : {2, 3}) {
      Scene scene = breakwater(triangle(1e6, 0.15));
      scene.fluid.bulk_modulus = std::numeric_limits<double>::infinity();
      scene.mesh.degree = degree;
      for (const char* name : {"seabed", "mound"}) scene.regions[name].flow = flow;
      scene.regions["mound"].conductivity_ratio = degree == 2 ? 1. : 0.2;
      const auto mesh = breakwater_mesh(0.5);
      const Compiled compiled(scene, *mesh);
      const ShearResponse shear = shear_of(compiled, run(compiled, 0.2, 0.0125));
      EXPECT_LE(shear.reaction_mismatch, 1e-8);
      EXPECT_NEAR(*shear.shear_to_force_ratio, 0.43, 0.03);
    }
}

}  // namespace open_sides_test
}  // namespace upbead::test
