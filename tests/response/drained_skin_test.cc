// Claims: the pressure of sand below rubble overshoots by overshoot(), after a jump and, at a sixth of its duration,
// under a triangle; an open side is no drained face. Source: Vermeer and Verruijt (1981) for the smallest time step.
// Tolerance: 0.03 of the undrained pressure, which the table is rounded and interpolated to.
#include "response/drainage.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace drained_skin_test {

constexpr double thickness = 10., above = 5., cell = 0.5;  // m
constexpr double q = 1e5;                                  // Pa

std::unique_ptr<Mesh> layers() {
  return tensor_mesh(
      {0., 1.}, joined(even_lines(0., thickness, 20), even_lines(thickness, thickness + above, 10)),
      [](const auto& at) { return at[1] < thickness ? "soil" : "rubble"; },
      [](const auto& at) -> std::string {
        if (at[1] == 0. || at[1] == thickness + above) return at[1] == 0. ? "base" : "top";
        return at[0] == 0. ? "left" : at[0] == 1. ? "right" : "";
      });
}

Scene scene_of(const TimeFunction& load, int degree) {
  Region soil = sand(), loose = rubble();
  soil.damping.reset();
  loose.damping.reset();
  soil.flow = loose.flow = Flow::darcy;
  loose.hydraulic_conductivity = 1e3;
  Scene scene = column(soil, load);
  scene.regions["rubble"] = loose;
  scene.time.inertia = false;
  scene.mesh.degree = degree;
  for (int i = 0; i < 40; ++i) scene.probes["p" + std::to_string(i)].at = {0.5, 0.25 * i};
  return scene;
}

/// Largest pressure of the soil over the undrained pressure, less 1.
double overshoot_of(const Scene& scene, double end, double step) {
  const auto mesh = layers();
  const Compiled compiled(scene, *mesh);
  const Material m = material(scene.regions.at("soil"), scene.fluid, scene.gravity);
  const double stiffness = m.lambda + 2. * m.G, undrained = q / stiffness / (1. / stiffness + m.storage);
  const Response response = run(compiled, end, step);
  double largest = 0.;
  for (int i = 0; i < 40; ++i)
    largest = std::max(largest, history(compiled, response, "probes/p" + std::to_string(i) + "/pressure").maxCoeff());
  return largest / undrained - 1.;
}

class DrainedSkin : public testing::TestWithParam<int> {
 protected:
  DrainedSkin() {
    const auto mesh = layers();
    face_ = drained_faces(scene_of(triangle(q, 1.), GetParam()), *mesh).at(0);
  }
  /// The time t (s) for which c_v t / h^2 is `ratio`, h the size of a cell.
  double time(double ratio) const { return ratio * cell * cell / face_.consolidation; }

  DrainedFace face_;
};

TEST_P(DrainedSkin, FaceIsKnown) {
  const auto mesh = layers();
  EXPECT_EQ(drained_faces(scene_of(triangle(q, 1.), GetParam()), *mesh).size(), 1U);
  EXPECT_EQ(face_.region, "soil");
  EXPECT_EQ(face_.into, "rubble");
  EXPECT_NEAR(face_.cell, cell, 1e-12);
  EXPECT_NEAR(smallest_time(face_, GetParam() - 1), time(GetParam() == 2 ? 1. / 6. : 1. / 40.), 1e-12);
}

TEST_P(DrainedSkin, JumpOvershootsSo) {
  const TimeFunction jump = piecewise_linear({0., 1e9}, {q, q});
  for (const double ratio : {1e-3, 0.016, 0.07, 0.3}) {
    const double t = time(ratio), told = overshoot(face_, GetParam() - 1, t);
    EXPECT_NEAR(overshoot_of(scene_of(jump, GetParam()), t, t), told, 0.03) << ratio;
  }
}

TEST_P(DrainedSkin, TriangleOvershootsAsAJumpInASixthOfIt) {
  for (const double ratio : {0.01, 0.1, 1.}) {
    const double D = time(ratio), told = overshoot(face_, GetParam() - 1, D / 6.);
    EXPECT_NEAR(overshoot_of(scene_of(triangle(q, D), GetParam()), 0.6 * D, D / 32.), told, 0.05) << ratio;
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, DrainedSkin, testing::Values(2, 3));

TEST(DrainedFaces, OpenSideIsNone) {
  const auto mesh = column_mesh(10., 10);
  EXPECT_TRUE(drained_faces(column(sand(), triangle(q, 1.)), *mesh).empty());
}

}  // namespace drained_skin_test
}  // namespace upbead::test
