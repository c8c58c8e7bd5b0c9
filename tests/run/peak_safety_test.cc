// Claims: the factor of strength at the peak of the wave is within a tenth of the least circle on two sections; where
// it is not, that is told; it falls with the load, is judged by its limit, is not computed unless asked for, and where
// the resultant leaves the base it fails with its reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "findings/find.h"
#include "strong_breakwater.h"

namespace upbead::test {
namespace peak_safety_test {

/// Sand and rubble; or clay under the sand's strength, with nothing but cohesion.
Scene asked_scene(double peak, bool clay) {
  Scene scene = strong_breakwater(peak);
  if (clay) scene.regions["seabed"].strength = Strength{0., 120e3, 0., 0.};
  scene.limits.peak_safety = 1.;
  return scene;
}

const Summary& asked(double peak, bool clay) {
  static std::map<std::pair<double, bool>, Summary> made;
  const auto key = std::pair(peak, clay);
  if (!made.count(key)) made[key] = Simulation(asked_scene(peak, clay), breakwater_mesh(0.5)).run().summary;
  return made[key];
}

const Check* peak_check(const Summary& summary) {
  for (const Check& one : summary.checks)
    if (one.name == "strength at the peak") return &one;
  return nullptr;
}

bool tells_that_circles_differ(const Summary& summary) {
  return std::any_of(summary.warnings.begin(), summary.warnings.end(),
                     [](const NumberedWarning& w) { return w.name == "circles_differ"; });
}

TEST(PeakSafety, AgreesWithCirclesOnTwoSections) {
  for (const bool clay : {false, true}) {
    const Summary& s = asked(1e6, clay);
    ASSERT_TRUE(s.peak_safety && s.peak_safety->lower && s.peak_safety->upper) << s.why_no_peak_safety;
    const PeakSafety& p = *s.peak_safety;
    EXPECT_LE(*p.upper - *p.lower, 0.006 * *p.lower) << p.why_open;
    ASSERT_TRUE(p.circle);
    EXPECT_NEAR(*p.lower, *p.circle, 0.1 * *p.circle) << "clay " << clay << ", block " << p.block.value_or(0.);
    EXPECT_FALSE(tells_that_circles_differ(s));
    EXPECT_EQ(p.moves, "slides landward");
    EXPECT_GT(*p.depth, 6.) << "below the mound, as the circle";
    EXPECT_GE(p.moments, 2);
    EXPECT_NEAR(p.time, *s.circles->governs->time, 1e-9);
  }
}

/// A strong mound spreads its load over soft clay, which slices do not, as they have no shear between them: docs,
/// peak-strength.md, with the lower bound of statics.
TEST(PeakSafety, TellsWhereCirclesDiffer) {
  Scene scene = asked_scene(1e6, true);
  scene.regions["seabed"].strength = Strength{0., 60e3, 0., 0.};
  const Summary s = Simulation(scene, breakwater_mesh(0.5)).run().summary;
  ASSERT_TRUE(s.peak_safety && s.peak_safety->lower && s.peak_safety->circle);
  EXPECT_GT(*s.peak_safety->lower, 1.1 * *s.peak_safety->circle);
  EXPECT_TRUE(tells_that_circles_differ(s));
}

TEST(PeakSafety, FallsWithTheLoadAndIsJudged) {
  const Summary &small = asked(2e5, false), &large = asked(1e6, false);
  EXPECT_LT(*large.peak_safety->upper, *small.peak_safety->lower);
  const Check* check = peak_check(large);
  ASSERT_TRUE(check && check->demand);
  EXPECT_EQ(*check->demand, *large.peak_safety->lower);
  EXPECT_EQ(check->holds, *check->demand >= 1.);
  Scene scene = asked_scene(1e6, false);
  scene.limits.peak_safety = 3.;
  EXPECT_EQ(checks_of(scene, large, {}).size(), large.checks.size());
  Summary judged = large;
  judged.checks = checks_of(scene, large, {});
  EXPECT_EQ(peak_check(judged)->holds, false);
}

TEST(PeakSafety, IsNotComputedUnlessAskedForAndTellsWhyNot) {
  Scene scene = asked_scene(2e5, false);
  scene.limits.peak_safety.reset();
  const Summary none = Simulation(scene, breakwater_mesh(0.5)).run().summary;
  EXPECT_FALSE(none.peak_safety);
  EXPECT_EQ(none.why_no_peak_safety, "");
  EXPECT_FALSE(peak_check(none));
  EXPECT_EQ(none.circles->governs->factor, asked(2e5, false).circles->governs->factor);
  const Summary over = Simulation(asked_scene(2e7, false), breakwater_mesh(0.5)).run().summary;
  ASSERT_TRUE(over.circles->leaves_time);
  EXPECT_FALSE(over.peak_safety);
  EXPECT_EQ(over.why_no_peak_safety.rfind("the resultant leaves the base", 0), 0u);
  ASSERT_TRUE(peak_check(over));
  EXPECT_EQ(peak_check(over)->holds, false);
}

}  // namespace peak_safety_test
}  // namespace upbead::test
