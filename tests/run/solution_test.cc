// Claims: a solution does not depend on [sliding], so that one solution serves all values of its keys; what findings
// make of a solution alone they make once for all of them.

#include <gtest/gtest.h>

#include "scenes.h"
#include "upbead/findings/find.h"
#include "upbead/run/simulation.h"

namespace upbead::test {
namespace solution_test {

Scene sliding_scene(double friction) {
  Scene scene = breakwater(triangle(1e6, 0.2));
  scene.time.end = 0.6;
  scene.time.scheme = TimeScheme::reduced;
  SlidingChoice& sliding = scene.sliding.emplace();
  sliding.friction = friction;
  sliding.submerged_weight = 5e5;
  return scene;
}

Simulation simulation_of(const Scene& scene) {
  return {scene, breakwater_mesh(0.35)};
}

TEST(Solution, IsTheSameWhateverSlidingSays) {
  Scene none = sliding_scene(0.6);
  none.sliding.reset();
  const Solution rough = solve(simulation_of(sliding_scene(0.6))), smooth = solve(simulation_of(sliding_scene(0.4))),
                 without = solve(simulation_of(none));
  EXPECT_EQ(rough.response.ends.reading, smooth.response.ends.reading);
  EXPECT_EQ(rough.response.ends.reading, without.response.ends.reading);
  const Summary own = find(smooth), served = find(with_sliding(rough, sliding_scene(0.4)));
  EXPECT_GT(own.sliding->history.by_history.residual, 0.);
  EXPECT_EQ(own.sliding->history.by_history.residual, served.sliding->history.by_history.residual);
  ASSERT_TRUE(own.sliding->coupled && served.sliding->coupled);
  EXPECT_EQ(own.sliding->coupled->slip.residual, served.sliding->coupled->slip.residual);
}

TEST(Solution, KeepsTheCurveOfALoadForOtherSliding) {
  const auto along_the_wall = [](double friction) {
    Scene scene = sliding_scene(friction);
    Load& load = scene.loads.at("impulse");
    load.kind = LoadKind::pressure;
    load.history = triangle(1.5e5, 0.2);
    load.along_curve = true;
    load.shape = {{0., 1.}, {16., 0.5}};
    return scene;
  };
  const Summary own = find(solve(simulation_of(along_the_wall(0.4)))),
                served = find(with_sliding(solve(simulation_of(along_the_wall(0.6))), along_the_wall(0.4)));
  ASSERT_TRUE(own.sliding->coupled && served.sliding->coupled);
  EXPECT_GT(own.sliding->coupled->slip.residual, 0.);
  EXPECT_EQ(own.sliding->coupled->slip.residual, served.sliding->coupled->slip.residual);
}

int n_calls = 0;
int counted(const Solution&) {
  return ++n_calls;
}

TEST(Solution, KeepsWhatIsMadeOfItAloneForOtherSliding) {
  const Solution rough = solve(simulation_of(sliding_scene(0.6)));
  const Solution smooth = with_sliding(rough, sliding_scene(0.4));
  EXPECT_EQ(rough.found->of(rough, counted), 1);
  EXPECT_EQ(smooth.found->of(smooth, counted), 1);
  const Solution other = solve(simulation_of(sliding_scene(0.6)));
  EXPECT_EQ(other.found->of(other, counted), 2);
}

}  // namespace solution_test
}  // namespace upbead::test
