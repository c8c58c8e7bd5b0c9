// Claims: a layer of mud that drains into the mound above has an additional compliance by the part of its first cell
// beyond the drained skin; the compliance of the other parts is computed again for one scene; without contrast of
// permeability, or with drained mud, there is no such layer.
#include "response/drainage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace drained_layer_test {

constexpr double width = 18., depth = 0.2, mound = 6.;  // m
constexpr double time = 0.075;                          // s

Scene mud_scene() {
  Scene scene = breakwater(triangle(1e6, 2. * time));
  Region& mud = scene.regions.at("seabed");
  mud.shear_modulus = 1e5;
  mud.hydraulic_conductivity = 1e-6;
  return scene;
}

std::optional<DrainedLayer> layer_of(Scene scene, int degree_of_pressure = 1,
                                     double depth = drained_layer_test::depth) {
  scene.mesh.degree = degree_of_pressure + 1;
  const auto mesh = breakwater_mesh(0.5, {{"caisson_width", width}, {"seabed_depth", depth}, {"mound_height", mound}});
  const Compiled compiled(scene, *mesh);
  return drained_layer(compiled.resolved, compiled.space, *compiled.scene.caisson, time);
}

TEST(DrainedLayer, YieldsByWhatCellsDrainBeyondTheSkin) {
  const Scene scene = mud_scene();
  const std::optional<DrainedLayer> layer = layer_of(scene);
  ASSERT_TRUE(layer);
  EXPECT_EQ(layer->region, "seabed");
  EXPECT_EQ(layer->into, "mound");
  const Material m = material(scene.regions.at("seabed"), scene.fluid, scene.gravity);
  const Material stones = material(scene.regions.at("mound"), scene.fluid, scene.gravity);
  const double E = m.lambda + 2. * m.G, skin = std::sqrt(time / m.b / (1. / E + m.storage));
  EXPECT_NEAR(layer->cell, depth, 1e-9);
  EXPECT_NEAR(layer->skin, skin, 1e-9);
  EXPECT_NEAR(layer->compliance * E, depth / 2. - skin, 1e-9);
  for (const double thick : {depth, 6.}) {  // of the second most of it is what the mud is squeezed
    const double squeezed = thick / (4. * m.G * (1. + width * width / (4. * thick * thick)));
    const double rest = mound / (stones.lambda + 2. * stones.G) + squeezed + skin / E;
    EXPECT_NEAR(layer_of(scene, 1, thick)->of_the_rest / rest, 1., 0.02);
  }
  EXPECT_NEAR(layer_of(scene, 2)->compliance * E, depth / 3. - skin, 1e-9);
}

TEST(DrainedLayer, IsNoneWhereNothingDrains) {
  Scene scene = mud_scene();
  scene.regions.at("seabed").hydraulic_conductivity = 0.1;
  EXPECT_FALSE(layer_of(scene));
  scene = mud_scene();
  scene.regions.at("seabed").flow = Flow::drained;
  EXPECT_FALSE(layer_of(scene));
}

}  // namespace drained_layer_test
}  // namespace upbead::test
