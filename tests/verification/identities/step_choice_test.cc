// Claims: the automatic step is an eighth of the shorter of the loads' duration and the caisson's apparent period (a
// 64th at order 2); the period follows from the caisson alone, not from loads elsewhere or their units; no step
// depends on the length of the run; a consolidation of days takes few steps and agrees with fine ones.
#include "response/time_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/factorisation.h"
#include "scenes.h"

namespace upbead::test {
namespace step_choice_test {

TimeFunction step_load(double peak, double rise = 0.) {
  Pulse pulse;
  pulse.shape = PulseShape::step;
  pulse.peak = peak;
  if (rise > 0.) pulse.rise = rise;
  return time_function(pulse);
}

Load ground_pressure(const TimeFunction& history) {
  Load load;
  load.boundary = "bed";
  load.kind = LoadKind::pressure;
  load.history = history;
  return load;
}

class StepChoiceOfBreakwater : public testing::Test {
 protected:
  StepChoice choose(const Scene& scene, int order = 4) const {
    return choose_step(scene, Compiled(scene, *mesh_).scene, order);
  }
  std::unique_ptr<Mesh> mesh_ = breakwater_mesh(0.5);
};

TEST_F(StepChoiceOfBreakwater, IsAFractionOfTheShorter) {
  const Scene scene = breakwater(triangle(1e6, 0.15));
  const StepChoice choice = choose(scene);
  EXPECT_GT(choice.apparent_period, 0.1);
  EXPECT_LT(choice.apparent_period, 1.);
  EXPECT_EQ(choice.factorisations, 1);
  EXPECT_DOUBLE_EQ(choice.largest_step, std::min(0.15, choice.apparent_period) / 8.);
  EXPECT_DOUBLE_EQ(choose(scene, 2).largest_step, std::min(0.15, choice.apparent_period) / 64.);
  const StepChoice slow = choose(breakwater(triangle(1e6, 30.)));
  EXPECT_DOUBLE_EQ(slow.largest_step, std::min(scene.time.end, slow.apparent_period) / 8.);
}

TEST_F(StepChoiceOfBreakwater, PeriodDoesNotDependOnLoadsOnTheGround) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  const double alone = choose(scene).apparent_period;
  scene.loads["wave"] = ground_pressure(triangle(2e9, 0.15));
  EXPECT_NEAR(choose(scene).apparent_period / alone, 1., 1e-10);
  // only the ground is loaded: the period is then that under a force through the centre of gravity
  scene.loads.erase("impulse");
  const double through_centre = choose(scene).apparent_period;
  EXPECT_GT(through_centre, 0.5 * alone);
  EXPECT_LT(through_centre, 2. * alone);
}

// The force computed from the caisson's rows equals the load: a rigid body's motion depends only on resultant and
// arm.
TEST_F(StepChoiceOfBreakwater, PeriodIsThatOfTheLoadItself) {
  std::vector<double> periods;
  for (const std::array<double, 2>& intensity : {std::array<double, 2>{1., 0.}, {0., 1.}}) {
    Scene scene = breakwater(triangle(1e6, 0.15));
    scene.loads["impulse"].shape = {{6., intensity[0]}, {22., intensity[1]}};
    const Compiled compiled(scene, *mesh_);
    const System& system = compiled.system;
    const double s = std::acos(-1.) / 0.15, mass = compiled.scene.caisson->body.mass;
    ASSERT_EQ(system.n_prescribed, 0);
    const Vector x = Factorisation(s * s * system.M + s * system.C + system.K, system.blocks)
                         .solve(system.loads[0].vector / compiled.scene.loads_on_caisson[0].force_x);
    double x_G = 0.;
    for (const auto& [i, weight] : system.readings[system.reading("caisson/displacement_x")].position)
      x_G += weight * x[i];
    const double expected = 2. * std::acos(-1.) * std::sqrt(mass / (1. / x_G - mass * s * s));
    periods.push_back(choose(scene).apparent_period);
    EXPECT_NEAR(periods.back() / expected, 1., 1e-9);  // round-off of two solves
  }
  EXPECT_GT(periods[1], 1.05 * periods[0]) << "a force high up also turns the caisson";
}

TEST_F(StepChoiceOfBreakwater, LoneJumpDoesNotDependOnTheEnd) {
  Scene scene = breakwater(step_load(1e6));
  scene.time.end = 2.;
  const StepChoice shorter = choose(scene);
  scene.time.end = 8.;
  const StepChoice longer = choose(scene);
  EXPECT_EQ(longer.factorisations, 3);
  EXPECT_DOUBLE_EQ(longer.largest_step, longer.apparent_period / 8.);
  // Two iterations leave little of the first guess of s; with end/20 as the step, the two steps differed by a factor
  // of 4.
  EXPECT_NEAR(longer.largest_step / shorter.largest_step, 1., 0.05);
}

TEST_F(StepChoiceOfBreakwater, JumpTakesTheDurationOfKinks) {
  Scene scene = breakwater(piecewise_linear({0., 0.02}, {1e6, 0.}));
  for (double end : {1., 100.}) {
    scene.time.end = end;
    EXPECT_DOUBLE_EQ(choose(scene).largest_step, 2. * 0.02 / 8.) << end;
  }
  scene = breakwater(step_load(1e6));
  scene.loads["wave"] = ground_pressure(triangle(1e3, 0.05));
  EXPECT_DOUBLE_EQ(choose(scene).largest_step, 0.05 / 8.);
}

Scene consolidation() {
  Scene scene = column(sand(), step_load(1e5, 0.1));
  scene.time.inertia = false;
  scene.time.end = 1e6;
  scene.probes["middle"].at = {0.5, 5.};
  scene.probes["top"].at = {0.5, 10.};
  return scene;
}

TEST(ConsolidationSteps, GrowOnlyOnceTheLoadsKeepTheirValues) {
  Scene scene = consolidation();
  const LoadStep steps = step_of_loads(scene, 4);
  ASSERT_TRUE(steps.growth);
  EXPECT_DOUBLE_EQ(steps.growth->after, 0.1);
  EXPECT_DOUBLE_EQ(steps.largest_step, 0.2 / 8.);
  scene.time.inertia = true;
  EXPECT_FALSE(step_of_loads(scene, 4).growth);
  scene.time.inertia = false;
  Pulse tide;
  tide.shape = PulseShape::harmonic;
  tide.peak = 1e4;
  tide.frequency = 0.1;
  scene.loads["tide"] = scene.loads["top"];
  scene.loads["tide"].history = time_function(tide);
  scene.loads["tide"].duration = duration(tide);
  EXPECT_FALSE(step_of_loads(scene, 4).growth);
}

TEST(ConsolidationSteps, DaysTakeFewStepsAndAgreeWithFineOnes) {
  const Scene scene = consolidation();
  const auto mesh = column_mesh(10., 10);
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const StepChoice choice = choose_step(scene, compiled.scene, 4);
  const auto settle = [&](double end, double step, const std::optional<StepGrowth>& growth, int* n_steps) {
    const auto scheme = make_scheme(system);
    const Response response = march(system, *scheme, make_time_grid(kinks(system), end, step, growth));
    *n_steps = response.n_steps;
    return history(compiled, response, "probes/top/displacement_y").tail<1>()[0];
  };
  int n_steps = 0, n_fine = 0;
  const double last = settle(1e6, choice.largest_step, choice.growth, &n_steps);
  EXPECT_LE(n_steps, 300);
  // Fully drained: sigma H / (lambda + 2 mu).
  const double G = 32.647e6, nu = 0.33, oedometric = 2. * G * (1. - nu) / (1. - 2. * nu);
  EXPECT_NEAR(last / (-1e5 * 10. / oedometric), 1., 1e-6);
  // In the middle of consolidation (c_v = k E_oed / (rho g) = 1.3 m2/s, H2 / c_v = 77 s).
  const double grown = settle(15., choice.largest_step, choice.growth, &n_steps);
  const double fine = settle(15., choice.largest_step, {}, &n_fine);
  EXPECT_LT(n_steps, n_fine / 5);
  EXPECT_NEAR(grown / fine, 1., 1e-4);
}

}  // namespace step_choice_test
}  // namespace upbead::test
