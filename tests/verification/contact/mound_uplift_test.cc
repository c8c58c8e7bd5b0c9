// Claim: where a pressure stands on mound and bed in front of the caisson alone, the steady flow of the pore water
// under the base makes an uplift of half that pressure times B on every section that is its own mirror image, whatever
// its soils let through: p(x) + p(-x) is the pressure in front. The pressure at the seaward edge is that in front, at
// the heel it is zero, and it falls between them.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/caisson/reading_names.h"
#include "scenes.h"
#include "upbead/run/simulation.h"

namespace upbead::test {
namespace mound_uplift_test {

constexpr double pressure = 5e4, width = 18.;

/// The section without the force on its wall, consolidating under that pressure on mound and bed in front of it.
Scene pressed_in_front(const std::vector<std::string>& curves) {
  Scene scene = breakwater({});
  scene.loads.clear();
  for (const std::string& curve : curves) {
    Load& load = scene.loads["on_" + curve];
    load.boundary = curve;
    load.kind = LoadKind::pressure;
    load.over_x = true;
    load.shape = {{-1e4, 1.}, {-0.5 * width, 1.}};
    load.history = piecewise_linear({0., 10., 1e9}, {0., pressure, pressure});
  }
  scene.time.inertia = false;
  scene.time.end = 4e5;
  scene.time.step = 4e3;
  scene.base_stress = true;
  return scene;
}

void expect_half(const Scene& scene, const std::shared_ptr<const Mesh>& mesh) {
  const upbead::Run run = Simulation(scene, mesh).run();
  const System& system = run.simulation->system();
  const auto last = [&](const std::string& name) {
    return run.response.ends.reading(system.reading(name), run.response.ends.reading.cols() - 1);
  };
  EXPECT_NEAR(last(reading::uplift) / (0.5 * pressure * width), 1., 1e-6);
  std::vector<double> under;
  for (const Reading& reading : system.readings)
    if (reading.name.group == "base" && reading.name.quantity == "pore_pressure")
      under.push_back(last(reading.name.text()));
  ASSERT_GT(under.size(), 5u);
  for (std::size_t i = 0; i < under.size(); ++i) {
    EXPECT_NEAR(under[i] + under[under.size() - 1 - i], pressure, 1e-6 * pressure) << i;
    if (i > 2 && i + 2 < under.size()) {
      EXPECT_LT(under[i], under[i - 2]) << i;
    }
  }
  EXPECT_GT(under.front(), 0.8 * pressure);
}

TEST(MoundUplift, OfASectionThatIsItsMirrorImageIsHalfThePressureInFront) {
  Scene scene = pressed_in_front({"mound_surface", "bed"});
  expect_half(scene, breakwater_mesh(0.25));
  scene.regions["mound"].hydraulic_conductivity = 1e-5;  // tighter than its seabed
  expect_half(scene, breakwater_mesh(0.25));
}

TEST(MoundUplift, IsThatOnARigidFloorToo) {
  Scene scene = pressed_in_front({"mound_surface"});
  for (const char* gone : {"left", "right", "bed"}) scene.boundaries.erase(gone);
  scene.regions.erase("seabed");
  expect_half(scene, breakwater_mesh(0.25, {{"seabed_depth", 0.}}));
}

}  // namespace mound_uplift_test
}  // namespace upbead::test
