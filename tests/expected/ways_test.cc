// Claims: on a rigid caisson every way to fail is statics at the peak of the wave: friction over force, margin, edge
// pressure, the least circle by the pressures that the wave brings; all of them worsen with the height; without circles
// nothing is told; a life keeps the worst wave of each of its storms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "caissons.h"
#include "expected/dynamic_law.h"
#include "upbead/expected/life.h"

namespace upbead::test {
namespace ways_test {

/// Two circles through a level ground of c' and phi' under a base of 12 m, one each way, from that x of the side away.
CircleFamily family() {
  CircleFamily f;
  f.left = -6.;
  f.right = 6.;
  for (const bool landward : {true, false})
    for (const double away : {-6.5, 1.5}) {
      const double from = landward ? away : -16., to = landward ? 16. : -away, x = 0.5 * (from + to), y = 12.;
      FamilyCircle c{x, y, std::hypot(to - x, y), from, to, landward, 0., {}};
      const int n = 40;
      for (int i = 0; i < n; ++i) {
        const double width = (to - from) / n, at = from + (i + 0.5) * width, side = landward ? 1. : -1.;
        const double depth = std::sqrt(c.radius * c.radius - (x - at) * (x - at)) - y;
        c.slices.push_back({at, width, side * (x - at) / c.radius, (depth + y) / c.radius, 50e3, 0.6, 9e3 * depth});
        c.weight_moment += side * 9e3 * depth * (x - at) * width;
      }
      f.circles.push_back(c);
    }
  return f;
}

/// A rigid caisson on rigid ground: F_T = P, N = 0.1 P, M = 1.5 m P; every reading of the circles is 3 mm of P.
ShearModel rigid(bool with_circles) {
  ShearModel model;
  model.modes.pole = Eigen::VectorXcd::Constant(1, {-100., 100.});
  model.modes.load = Eigen::MatrixXcd::Constant(1, 1, 1.);
  model.modes.reading = Eigen::MatrixXcd::Zero(5, 1);
  model.modes.feedthrough = model.modes.impulse = Eigen::MatrixXd::Zero(5, 1);
  model.modes.feedthrough.col(0) << 1., 0.1, 1.5, 0., 0.;
  model.modes.load_name = {"impact"};
  model.modes.reading_label.assign(5, {});
  model.caisson_mass = medium_caisson().section.weight / 9.81;
  model.base = {1, 2, 3, 4};
  if (!with_circles) return model;
  CircleModel circles{family(), model.modes, 0.};
  const auto n = static_cast<Eigen::Index>(circles.family.n_readings());
  circles.pressures.reading = Eigen::MatrixXcd::Zero(n, 1);
  circles.pressures.feedthrough = Eigen::MatrixXd::Constant(n, 1, 3e-3);
  circles.pressures.impulse = Eigen::MatrixXd::Zero(n, 1);
  model.circles = std::make_shared<const CircleModel>(circles);
  return model;
}

DynamicLaw law_of(const ShearModel& model) {
  ImpactAssumptions assumptions;
  assumptions.uplift = ImpactUplift::in_phase;
  return {medium_caisson(), storm(6.), assumptions, std::make_shared<const ShearAnswer>(model, 2e-3, 10.)};
}

TEST(Ways, OfARigidCaissonAreStatics) {
  const DynamicLaw law = law_of(rigid(true));
  const DynamicWave wave = law.wave(8.);
  const WaysToFail ways = law.ways(8.).value();
  const Section s = medium_caisson().section;
  const double P = *std::max_element(wave.force.begin(), wave.force.end());
  const double U = wave.wave.uplift * P / std::max(wave.wave.peak, wave.wave.reduction * wave.wave.standing_force);
  const double N = s.submerged_weight + 0.1 * P - U, M = 1.5 * P + U * s.width / 6.;
  EXPECT_NEAR(ways.sliding, s.friction * N / P, 1e-9 * ways.sliding);
  EXPECT_EQ(ways.sliding_seaward, WaysToFail::never);
  EXPECT_NEAR(ways.heel_pressure, law.base(8.)->heel_pressure, 1e-9 * ways.heel_pressure);
  EXPECT_NEAR(ways.overturning, law.base(8.)->overturning_margin, 1e-12);
  const CircleFamily circles = family();
  const std::vector<double> readings(circles.n_readings(), 3e-3 * P);
  const double still = least_factor(circles, {N, P, M}, nullptr).value().factor;
  const double computed = least_factor(circles, {N, P, M}, readings.data()).value().factor;
  EXPECT_GT(std::abs(still - computed), 1e-3 * still);
  EXPECT_NEAR(ways.circles, std::min(still, computed), 1e-9 * still);
}

TEST(Ways, WorsenWithTheHeight) {
  const DynamicLaw law = law_of(rigid(true));
  WaysToFail before;
  for (const double height : {2., 4., 6., 8., 10.}) {
    const WaysToFail ways = law.ways(height).value();
    EXPECT_TRUE(worst_of(before, ways) == ways) << height;
    before = ways;
  }
}

TEST(Ways, AreNotToldWithoutCircles) {
  EXPECT_FALSE(law_of(rigid(false)).ways(8.));
  ShearModel without_base = rigid(true);
  without_base.base.clear();
  EXPECT_FALSE(law_of(without_base).ways(8.));
}

LifeSetup setup(bool every_wave) {
  LifeSetup s;
  s.states = {storm(6.), storm(4.), {1., 8., 2e3, 0., 0.}};
  s.record_years = 1.;
  s.life_years = 4.;
  s.law = [](const SeaState& sea) { return formula_law(Law::exact, medium_caisson(), sea); };
  s.every_wave = every_wave;
  s.worst_of_storms = true;
  return s;
}

TEST(Ways, KnowTheWorstWaveOfEachStorm) {
  for (const bool every_wave : {false, true}) {
    const LifeSimulation simulation(setup(every_wave));
    for (std::uint32_t i = 0; i < 20; ++i) {
      const Life life = simulation.life(i);
      ASSERT_EQ(life.worst_of_storms.size(), 12U);
      double most = 0., highest = 0.;
      for (const DrawnWave& wave : life.worst_of_storms) {
        most = std::max(most, wave.heel_pressure);
        highest = std::max(highest, wave.height);
      }
      EXPECT_EQ(most, life.most_tilting.heel_pressure);
      EXPECT_GE(highest, life.most_tilting.height);
      if (std::isfinite(most)) {
        EXPECT_EQ(highest, life.most_tilting.height);
      }
      EXPECT_GT(life.worst_of_storms[0].height, life.worst_of_storms[2].height);
    }
  }
  LifeSetup without = setup(false);
  without.worst_of_storms = false;
  EXPECT_TRUE(LifeSimulation(without).life(0).worst_of_storms.empty());
}

}  // namespace ways_test
}  // namespace upbead::test
