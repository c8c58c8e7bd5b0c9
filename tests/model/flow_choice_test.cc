// Claim: the flow is chosen by X = k omega / (g n) at the end of the loads' spectrum, and the reason states the
// number.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/choices.h"

namespace upbead {

namespace flow_choice_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

Pulse triangle(double duration) {
  Pulse pulse;
  pulse.peak = 1.;
  pulse.duration = duration;
  return pulse;
}

Scene scene_with(const Pulse& pulse) {
  Scene scene;
  scene.loads["a"].history = time_function(pulse);
  scene.loads["a"].duration = duration(pulse);
  return scene;
}

Region porous(double conductivity) {
  Region region;
  region.porosity = 0.4;
  region.hydraulic_conductivity = conductivity;
  return region;
}

TEST(ShortestDuration, IsThatOfTheFastestLoad) {
  Scene scene = scene_with(triangle(0.1));
  EXPECT_NEAR(shortest_duration(scene), 0.1, 1e-15);
  scene.loads["b"].history = time_function(triangle(0.04));
  EXPECT_NEAR(shortest_duration(scene), 0.04, 1e-15);
  EXPECT_EQ(shortest_duration(Scene{}), infinity);
}

TEST(ShortestDuration, OfAChurchRoofIsTwiceItsShortestFlank) {
  Pulse pulse = triangle(0.2);
  pulse.shape = PulseShape::church_roof;
  pulse.rise = 0.05;
  pulse.plateau = 0.3;
  pulse.plateau_duration = 3.;
  EXPECT_NEAR(shortest_duration(scene_with(pulse)), 0.1, 1e-15);
}

TEST(ShortestDuration, OfASineIsHalfItsPeriod) {
  Pulse pulse = triangle(0.3);
  pulse.shape = PulseShape::half_sine;
  EXPECT_NEAR(shortest_duration(scene_with(pulse)), 0.3, 1e-15);
  pulse = {};
  pulse.shape = PulseShape::harmonic;
  pulse.peak = 1.;
  pulse.frequency = 4.;
  EXPECT_NEAR(shortest_duration(scene_with(pulse)), 0.125, 1e-15);
}

TEST(ShortestDuration, OfAJumpIsZero) {
  Pulse pulse;
  pulse.shape = PulseShape::step;
  pulse.peak = 1.;
  EXPECT_EQ(shortest_duration(scene_with(pulse)), 0.);
  pulse.rise = 0.01;
  EXPECT_NEAR(shortest_duration(scene_with(pulse)), 0.02, 1e-15);
}

TEST(FlowChoiceTest, RubbleUnderAnImpactIsInertial) {
  const FlowChoice choice = choose_flow(porous(0.1), {}, scene_with(triangle(0.1)));
  EXPECT_EQ(choice.flow, Flow::inertial);
  EXPECT_NEAR(choice.X, 0.1 * 40. / 0.1 / (9.81 * 0.4), 1e-9);
  EXPECT_EQ(
      choice.reason,
      "X = k omega/(g n) = 10.2 > 0.15 at omega = 400 rad/s, the end of the loads' spectrum: the water's own inertia "
      "counts");
}

TEST(FlowChoiceTest, SandUnderAnImpactIsDarcy) {
  const FlowChoice choice = choose_flow(porous(1e-4), {}, scene_with(triangle(0.1)));
  EXPECT_EQ(choice.flow, Flow::darcy);
  EXPECT_EQ(
      choice.reason,
      "X = k omega/(g n) = 0.0102 <= 0.15 at omega = 400 rad/s, the end of the loads' spectrum: drag outweighs the "
      "water's own inertia");
}

TEST(FlowChoiceTest, AJumpIsInertialUnlessQuasiStatic) {
  Pulse pulse;
  pulse.shape = PulseShape::step;
  pulse.peak = 1.;
  Scene scene = scene_with(pulse);
  EXPECT_EQ(choose_flow(porous(1e-4), {}, scene).flow, Flow::inertial);
  EXPECT_EQ(choose_flow(porous(1e-4), {}, scene).X, infinity);
  scene.time.inertia = false;
  EXPECT_EQ(choose_flow(porous(1e-4), {}, scene).flow, Flow::darcy);
  EXPECT_EQ(choose_flow(porous(1e-4), {}, scene).reason, "quasi-static (time.inertia = false): no inertia to move");
}

TEST(FlowChoiceTest, WithoutLoadsIsDarcy) {
  const FlowChoice choice = choose_flow(porous(0.1), {}, Scene{});
  EXPECT_EQ(choice.flow, Flow::darcy);
  EXPECT_EQ(choice.X, 0.);
}

TEST(FlowChoiceTest, KeepsWhatIsStated) {
  Region region = porous(0.1);
  for (const Flow stated : {Flow::darcy, Flow::inertial, Flow::drained}) {
    region.flow = stated;
    EXPECT_EQ(choose_flow(region, {}, scene_with(triangle(0.1))).flow, stated);
  }
  EXPECT_EQ(choose_flow(region, {}, Scene{}).reason, "stated in the case");
}

}  // namespace flow_choice_test
}  // namespace upbead
