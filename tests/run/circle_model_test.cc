// Claims: the factor of a circle by the readings of a reduced model is that of the same circle in the run, at the same
// moment and with the same pore pressure; the least of the family is as near to the run's own search as the model says;
// a scene without strength has no family.
#include "findings/circle_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/readings_at.h"
#include "fem/compile.h"
#include "findings/ground_section.h"
#include "response/reduction.h"
#include "rupture/fixed_circle.h"
#include "strong_breakwater.h"

namespace upbead::test {
namespace circle_model_test {

struct Made {
  explicit Made(double peak) : simulation(strong_breakwater(peak), breakwater_mesh(0.5)) {
    ReductionTargets targets{true, true, {}};
    targets.pressures = true;
    reduction = reduce_scene(simulation.scene(), *simulation.compiled(), targets);
    model = circle_model(simulation, reduction);
  }
  Simulation simulation;
  Reduction reduction;
  CircleModelMade model;
};

const Made& made() {
  static const Made one(1e5);
  return one;
}

SlipCircles circles_of_run(double peak) {
  return *Simulation(strong_breakwater(peak), breakwater_mesh(0.5)).run().summary.circles;
}

/// F of a run's circle by readings of the reduced model at its moment.
double by_readings(const SlipCircleFound& c, bool computed) {
  const Simulation& simulation = made().simulation;
  CircleFamily family;
  const Caisson& caisson = *simulation.compiled()->caisson;
  family.left = caisson.bottom_centre[0] - 0.5 * caisson.bottom_width;
  family.right = family.left + caisson.bottom_width;
  family.level = caisson.bottom_centre[1];
  const SlipsTo slips = c.slips == "landward" ? SlipsTo::right : SlipsTo::left;
  family.circles.push_back(
      *family_circle(ground_section(simulation), {}, {c.centre[0], c.centre[1], c.radius}, slips, c.from, c.to, 40));
  const BaseLoad load{c.force, c.shear, c.moment};
  if (!computed) return *factor_of(family, 0, load, nullptr);
  const ModalModel model = circle_readings(family, simulation, *made().reduction.pressures);
  const SampledLoads loads = sampled_loads(simulation.scene(), simulation.system());
  const auto at = std::min_element(loads.time.begin(), loads.time.end(),
                                   [&](double a, double b) { return std::abs(a - *c.time) < std::abs(b - *c.time); });
  const Eigen::MatrixXd readings = respond_at(model, loads, {static_cast<std::size_t>(at - loads.time.begin())});
  return *factor_of(family, 0, load, readings.data());
}

TEST(CircleModel, HasTheFactorOfTheSameCircleInTheRun) {
  const SlipCircles run = circles_of_run(1e5);
  EXPECT_NEAR(by_readings(*run.at_rest, false), run.at_rest->factor, 0.01 * run.at_rest->factor);
  EXPECT_NEAR(by_readings(*run.still, false), run.still->factor, 0.01 * run.still->factor);
  EXPECT_NEAR(by_readings(*run.computed, true), run.computed->factor, 0.01 * run.computed->factor);
  const double with = std::abs(by_readings(*run.computed, true) - run.computed->factor);
  EXPECT_GT(std::abs(by_readings(*run.computed, false) - run.computed->factor), 1.5 * with) << "the pressure matters";
}

TEST(CircleModel, IsAsNearToAFullSearchAsItSays) {
  ASSERT_TRUE(made().model.model) << made().model.why_not;
  const CircleModel& model = *made().model.model;
  EXPECT_LT(model.gap, 0.05) << "told, and not larger than some percent";
  EXPECT_GT(model.family.circles.size(), 10U);
  EXPECT_LT(model.family.circles.size(), 60U);
}

TEST(CircleModel, NeedsAStrength) {
  Scene scene = strong_breakwater(1e5);
  for (const char* region : {"seabed", "mound"}) scene.regions[region].strength.reset();
  const Simulation simulation(scene, breakwater_mesh(0.5));
  const CircleModelMade none = circle_model(simulation, made().reduction);
  EXPECT_FALSE(none.model);
  EXPECT_EQ(none.why_not, "no region has a table strength");
}

}  // namespace circle_model_test
}  // namespace upbead::test
