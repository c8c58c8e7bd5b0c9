// Claims: the first reflection is that of the nearer far side, at the distance from the mound's toe and by shear
// waves; absorbing sides reflect only in saturated ground; a column has no reflection, and a sea does not hide that
// of the ground.
#include "response/ground_waves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace boundary_reflection_test {

const double speed = std::sqrt(32.647e6 / (0.6 * 2650. + 0.4 * 1030.));

Scene scene_of(DisplacementCondition sides) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  for (const char* side : {"left", "right"}) scene.boundaries[side].displacement = sides;
  return scene;
}

std::optional<BoundaryReflection> reflection_of(const Scene& scene, const Mesh& mesh) {
  return first_reflection(scene, Space(mesh, scene));
}

TEST(BoundaryReflection, ComesFromTheNearerSide) {
  const auto mesh = breakwater_mesh(0.35, {{"seabed_front", 60.}, {"seabed_back", 30.}});
  const auto reflection = reflection_of(scene_of(DisplacementCondition::roller), *mesh);
  ASSERT_TRUE(reflection);
  EXPECT_EQ(reflection->side, "right");
  EXPECT_NEAR(reflection->distance, 30., 1e-9);
  EXPECT_NEAR(reflection->time(), 60. / speed, 1e-9);
}

TEST(BoundaryReflection, OfAbsorbingSidesIsHeardInSaturatedGround) {
  const auto mesh = breakwater_mesh(0.35);
  Scene scene = scene_of(DisplacementCondition::absorbing);
  const auto reflection = reflection_of(scene, *mesh);
  ASSERT_TRUE(reflection);
  EXPECT_TRUE(reflection->absorbing);
  scene.regions["seabed"].flow = Flow::drained;
  EXPECT_FALSE(reflection_of(scene, *mesh));
}

TEST(BoundaryReflection, IsOfTheGroundBelowASea) {
  Scene scene = scene_of(DisplacementCondition::roller);
  add_sea(scene);
  const auto mesh = breakwater_mesh(0.35, with_sea());
  const auto reflection = reflection_of(scene, *mesh);
  ASSERT_TRUE(reflection);
  EXPECT_NEAR(reflection->distance, 120., 1e-9);
}

TEST(BoundaryReflection, ColumnHasNone) {
  const auto mesh = column_mesh(10., 10);
  EXPECT_FALSE(reflection_of(column(sand(), triangle(1e5, 0.1)), *mesh));
}

}  // namespace boundary_reflection_test
}  // namespace upbead::test
