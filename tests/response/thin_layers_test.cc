// Claims: a soft layer that is thin beside the caisson is found, with its thickness and the longest cell along it;
// none is found where the ground is thick, or as stiff as its neighbour.
#include "response/ground_waves.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace upbead::test {
namespace thin_layers_test {

std::vector<ThinLayer> layers(double depth, double modulus, double cells) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  scene.regions["seabed"].shear_modulus = modulus;
  const auto mesh = breakwater_mesh(cells, {{"seabed_depth", depth}});
  const Compiled compiled(scene, *mesh);
  return thin_layers(compiled.space, *compiled.scene.caisson);
}

TEST(ThinLayers, AreFoundWithTheirCells) {
  const std::vector<ThinLayer> mud = layers(0.2, 1e5, 1.);
  ASSERT_EQ(mud.size(), 1U);
  EXPECT_EQ(mud[0].region, "seabed");
  EXPECT_NEAR(mud[0].thickness, 0.2, 1e-9);
  EXPECT_GT(mud[0].contrast, 5.);
  EXPECT_LT(mud[0].cells_per_thickness(), 0.5);
  EXPECT_GT(layers(0.2, 1e5, 2.)[0].cells_per_thickness(), 1.5 * mud[0].cells_per_thickness());
}

TEST(ThinLayers, AreNeitherThickNorStiff) {
  EXPECT_TRUE(layers(15., 1e5, 1.).empty());
  EXPECT_TRUE(layers(0.2, 1e8, 1.).empty());
}

}  // namespace thin_layers_test
}  // namespace upbead::test
