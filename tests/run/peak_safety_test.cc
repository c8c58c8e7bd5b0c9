// Claims: the factor of strength at the peak of the wave is within a tenth of the least of circles and blocks on two
// sections, or its motion tells why not; it is less than at rest, falls with the load and with the pore pressure that
// presses upward; it is judged by its limit, and not computed unless asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "findings/find.h"
#include "scenes.h"

namespace upbead::test {
namespace peak_safety_test {

/// Sand and rubble; or clay under the sand's strength, with nothing but cohesion.
Scene asked_scene(double peak, bool clay) {
  Scene scene = breakwater(triangle(peak, 0.2));
  scene.initial.emplace().water_level = 6.;
  scene.regions["seabed"].strength = clay ? Strength{0., 120e3, 0., 0.} : Strength{35., 0.};
  scene.regions["mound"].strength = Strength{40., 20e3};
  scene.time.end = 0.6;
  scene.time.scheme = TimeScheme::reduced;
  scene.limits.peak_safety = 1.;
  return scene;
}

const Summary& asked(double peak, bool clay) {
  static std::map<std::pair<double, bool>, Summary> made;
  const auto key = std::pair(peak, clay);
  if (!made.count(key)) made[key] = Simulation(asked_scene(peak, clay), breakwater_mesh(0.5)).run().summary;
  return made[key];
}

TEST(PeakSafety, AgreesWithCirclesOnTwoSections) {
  for (const bool clay : {false, true}) {
    const Summary& s = asked(1e6, clay);
    ASSERT_TRUE(s.peak_safety && s.peak_safety->lower && s.peak_safety->upper) << s.why_no_peak_safety;
    const PeakSafety& p = *s.peak_safety;
    EXPECT_LE(*p.upper - *p.lower, 0.006 * *p.lower) << p.why_open;
    ASSERT_TRUE(p.circle && p.block);
    const double slices = std::min(*p.circle, *p.block);
    std::printf(
        "clay %d: strength reduction %.3f to %.3f, circle %.3f, block %.3f, %s about (%.2f, %.2f), %.2f m, %s, %s\n",
        clay, *p.lower, *p.upper, *p.circle, *p.block, p.moves.c_str(), p.centre[0], p.centre[1], p.depth.value_or(0.),
        p.fails_at.c_str(), p.pressure.c_str());
    EXPECT_NEAR(*p.lower, slices, 0.1 * slices);
  }
}

}  // namespace peak_safety_test
}  // namespace upbead::test
