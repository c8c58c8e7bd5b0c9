// Claims: the shortest wave is V_s D + B of each region that deforms, the cell the largest within it, and half the
// density of cells gives half as many cells per wavelength.
#include "response/ground_waves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace wave_resolution_test {

constexpr double duration = 0.15, width = 18.;  // s, m

std::vector<WaveResolution> resolution(double cells) {
  const Scene scene = breakwater(triangle(1e6, duration));
  const auto mesh = breakwater_mesh(cells, {{"caisson_width", width}});
  const Compiled compiled(scene, *mesh);
  return wave_resolution(compiled.space, *compiled.scene.caisson, duration);
}

TEST(WaveResolution, IsOfEveryRegionThatDeforms) {
  const std::vector<WaveResolution> list = resolution(1.);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].region, "mound");
  EXPECT_EQ(list[1].region, "seabed");
  const double speed = std::sqrt(32.647e6 / (0.6 * 2650. + 0.4 * 1030.));
  EXPECT_NEAR(list[1].speed, speed, 1e-9);
  EXPECT_NEAR(list[1].wavelength, speed * duration + width, 1e-9);
  EXPECT_GT(list[1].cell, list[0].cell);
}

/// Within 4.2 m of the bottom of a narrow caisson, which stands at 6 m, there is only its mound.
TEST(WaveResolution, LooksNoFartherThanAWave) {
  const Scene scene = breakwater(triangle(1e6, duration));
  const auto mesh = breakwater_mesh(1., {{"caisson_width", 4.}});
  const Compiled compiled(scene, *mesh);
  const std::vector<WaveResolution> list = wave_resolution(compiled.space, *compiled.scene.caisson, 1e-3);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].region, "mound");
}

TEST(WaveResolution, FollowsTheMesh) {
  const double ratio = resolution(1.)[1].cells_per_wave() / resolution(0.5)[1].cells_per_wave();
  EXPECT_NEAR(ratio, 2., 0.2);
}

}  // namespace wave_resolution_test
}  // namespace upbead::test
