// Claims: the least absolute pressure of a march is the least of all nodes and steps, atmosphere and depth included;
// a reduced model gives the same place and value as the march. Tolerances: round-off; 3 % of the excess for the
// reduced model, whose pressures have that error.
#include "response/monitors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "fem/static_stage.h"
#include "response/reduction.h"
#include "scenes.h"

namespace upbead::test {
namespace least_pressure_test {

TEST(LeastPressure, IsThatOfAllNodesAndSteps) {
  constexpr double height = 10., level = 9.;
  constexpr int cells = 10;
  Scene scene = column(sand(), triangle(-1.5e5, 0.1));  // under tension
  for (int i = 0; i <= cells; ++i) scene.probes["p" + std::to_string(i)].at = {0.5, height * i / cells};
  const auto mesh = column_mesh(height, cells);
  const Compiled compiled(scene, *mesh);
  LeastPressure least(compiled.space, compiled.unknowns, compiled.resolved, level);
  const auto scheme = make_scheme(compiled.system);
  MarchOptions options;
  options.observers = {&least};
  const Response response =
      march(compiled.system, *scheme, make_time_grid(kinks(compiled.system), 0.1, 0.005), options);

  double expected = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= cells; ++i) {
    const double y = height * i / cells, still = atmosphere + scene.fluid.density * scene.gravity * (level - y);
    if (y <= level)
      expected = std::min(expected,
                          still + history(compiled, response, "probes/p" + std::to_string(i) + "/pressure").minCoeff());
  }
  EXPECT_TRUE(least.has_seen());
  EXPECT_LT(expected, vapour_pressure);
  EXPECT_NEAR(least.value(), expected, 1e-6);
  EXPECT_EQ(least.region(), "soil");
  EXPECT_LE(least.place()[1], level);

  LeastPressure resumed(compiled.space, compiled.unknowns, compiled.resolved, level);
  resumed.recall(least.memory());
  EXPECT_EQ(resumed.value(), least.value());
  EXPECT_EQ(resumed.time(), least.time());
  EXPECT_EQ(resumed.place(), least.place());
}

TEST(LeastPressure, OfAReducedModelIsThatOfTheMarch) {
  Scene scene = breakwater(triangle(4e7, 0.15));
  add_sea(scene);
  scene.time.end = 0.4;
  const auto mesh = breakwater_mesh(0.35, with_sea());
  const Compiled compiled(scene, *mesh);
  const double level = water_level(compiled.resolved, *mesh);
  EXPECT_NEAR(level, 15., 1e-9);

  LeastPressure marched(compiled.space, compiled.unknowns, compiled.resolved, level);
  const auto scheme = make_scheme(compiled.system);
  MarchOptions options;
  options.observers = {&marched};
  march(compiled.system, *scheme, make_time_grid(kinks(compiled.system), scene.time.end, 0.15 / 32.), options);

  ReductionTargets aim;
  aim.pressures = true;
  const Reduction reduction = reduce_scene(compiled.resolved, compiled.scene, aim);
  LeastPressure reduced(compiled.space, compiled.unknowns, compiled.resolved, level);
  ASSERT_TRUE(reduction.pressures);
  reduced.see(*reduction.pressures, sampled_loads(compiled.resolved, compiled.system), 0.15);
  const double still = atmosphere + scene.fluid.density * scene.gravity * (level - marched.place()[1]);
  EXPECT_LT(marched.value(), still - 1e4);
  EXPECT_NEAR(reduced.value(), marched.value(), 0.03 * (still - marched.value()));
  EXPECT_EQ(reduced.region(), marched.region());
  EXPECT_FALSE(reduce_scene(compiled.resolved, compiled.scene, {}).pressures);
}

}  // namespace least_pressure_test
}  // namespace upbead::test
