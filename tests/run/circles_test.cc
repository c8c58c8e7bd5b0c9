// Claims: the section of a mesh has its surface, soils and weights; in a run circles are found at rest and in motion,
// by the pressure of still water and by that computed; what governs is the least of them, agrees with the circle
// evaluated by itself, and falls with the load; its factor over time has its least value at its moment, and its slices
// make its factor again; under loads that act slowly motion changes nothing; a limit makes a check, a factor below 1 a
// warning; without a strength it is told why there are none. A surcharge counts where it lies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "findings/find.h"
#include "findings/ground_section.h"
#include "rupture/circle_search.h"
#include "strong_breakwater.h"

namespace upbead::test {
namespace circles_test {

Simulation simulation_of(const Scene& scene) {
  return Simulation(scene, breakwater_mesh(0.5));
}

const Summary& summary_of(double peak) {
  static std::map<double, Summary> made;
  if (!made.count(peak)) made[peak] = simulation_of(strong_breakwater(peak)).run().summary;
  return made[peak];
}

bool warns(const Summary& summary, const std::string& code) {
  return std::any_of(summary.warnings.begin(), summary.warnings.end(),
                     [&](const NumberedWarning& w) { return w.name == code; });
}

const Check* check_named(const Summary& summary, const std::string& name) {
  for (const Check& check : summary.checks)
    if (check.name == name) return &check;
  return nullptr;
}

TEST(Circles, AreOfTheSectionOfTheMesh) {
  const Simulation simulation = simulation_of(strong_breakwater(1e5));
  const GroundSection section = ground_section(simulation);
  const Mesh& mesh = *simulation.mesh();
  double area = 0., weight = 0.;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell) != "caisson") area += area_of(cell);
  const int n = 4000;
  const double step = (section.right() - section.left()) / n;
  double found = 0.;
  for (int i = 0; i < n; ++i) {
    const auto column = section.column(section.left() + (i + 0.5) * step);
    ASSERT_TRUE(column && column->is_whole);
    ASSERT_EQ(column->layers.back().soil, no_soil);
    found += (column->surface() - column->layers.back().top) * step;
    weight = std::max(weight, section.weight_above(*column, column->layers.back().top).force);
  }
  EXPECT_NEAR(found, area, 1e-4 * area);
  EXPECT_GT(weight, 0.);
  const Region& sand = simulation.scene().regions.at("seabed");
  const auto edge = section.column(section.left() + 1e-3);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(section.weight_above(*edge, edge->surface() - 1.).force,
              (1. - *sand.porosity) * (*sand.grain_density - 1030.) * simulation.scene().gravity, 1.);
}

TEST(Circles, GovernByTheLeast) {
  const Summary& s = summary_of(1e5);
  ASSERT_TRUE(s.circles && s.circles->at_rest && s.circles->still && s.circles->computed && s.circles->governs);
  EXPECT_EQ(s.why_no_circles, "");
  const SlipCircles& c = *s.circles;
  EXPECT_EQ(c.governs->factor, std::min({c.at_rest->factor, c.still->factor, c.computed->factor}));
  EXPECT_FALSE(c.at_rest->time);
  EXPECT_EQ(c.still->slips, "landward");
  EXPECT_LT(c.still->factor, c.at_rest->factor);
  EXPECT_NE(c.still->factor, c.computed->factor);
  EXPECT_TRUE(c.block);
  ASSERT_TRUE(check_named(s, "slip circles"));
  EXPECT_FALSE(check_named(s, "slip circles")->holds);
  EXPECT_FALSE(warns(s, "circles_open"));
}

TEST(Circles, AgreeWithTheCircleByItself) {
  const Simulation simulation = simulation_of(strong_breakwater(1e5));
  for (const SlipCircleFound& c : {*summary_of(1e5).circles->still, *summary_of(1e5).circles->at_rest}) {
    GroundLoads loads;
    const double q = c.force / (c.strip_to - c.strip_from);
    const auto& caisson = *simulation.compiled()->caisson;
    loads.strip = {c.strip_from, c.strip_to, q, q, c.shear, caisson.bottom_centre[1]};
    const double middle = 0.5 * (c.strip_from + c.strip_to) - caisson.bottom_centre[0];
    EXPECT_NEAR(middle, c.moment / c.force, 1e-9 * caisson.bottom_width);
    const FigureSafety found =
        circle_safety(ground_section(simulation), loads, {c.centre[0], c.centre[1], c.radius},
                      c.slips == "landward" ? SlipsTo::right : SlipsTo::left, c.from, c.to, 4000);
    EXPECT_NEAR(found.factor, c.factor, 3e-3 * c.factor);
  }
}

TEST(Circles, AreFollowedOverTime) {
  const SlipCircles& c = *summary_of(1e5).circles;
  const auto& [time, factor] = c.course;
  ASSERT_EQ(time.size(), factor.size());
  ASSERT_GT(time.size(), 10u);
  std::size_t least = 0;
  for (std::size_t i = 0; i < factor.size(); ++i)
    if (factor[i] < factor[least] || std::isnan(factor[least])) least = i;
  EXPECT_NEAR(factor[least], c.governs->factor, 2e-2 * c.governs->factor);
  const auto at = static_cast<std::size_t>(std::find(time.begin(), time.end(), *c.governs->time) - time.begin());
  ASSERT_LT(at, time.size());
  EXPECT_NEAR(factor[at], c.governs->factor, 1e-9);  // no other one is less safe then
  EXPECT_NEAR(factor.front(), c.at_rest->factor, 1e-3 * c.at_rest->factor);
  for (std::size_t i = 1; i < factor.size(); ++i)
    EXPECT_LT(std::abs(factor[i] - factor[i - 1]), 0.05 * factor[i]) << "no jump at " << time[i] << " s";
}

/// Bishop's sum over the slices that are told, with the strengths of the regions at their bases.
TEST(Circles, HaveTheSlicesOfTheirFactor) {
  const SlipCircles& c = *summary_of(1e5).circles;
  const GroundSection section = ground_section(simulation_of(strong_breakwater(1e5)));
  const SlipCircleSlices& s = c.slices;
  double sum = 0.;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const GroundSoil* soil = section.soil_at(*section.column(s.x[i]), s.base[i]);
    ASSERT_TRUE(soil);
    const double side = c.governs->slips == "landward" ? 1. : -1.;
    const double sine = side * (c.governs->centre[0] - s.x[i]) / c.governs->radius,
                 cosine = std::sqrt(1. - sine * sine);
    sum += (soil->cohesion + (s.weight[i] - s.pressure[i]) * soil->friction) * s.width[i] /
           (cosine + sine * soil->friction / c.governs->factor);
  }
  EXPECT_NEAR(sum / c.governs->driving, c.governs->factor, 0.01 * c.governs->factor);
}

TEST(Circles, OfASlowLoadAreThoseWithoutMotion) {
  Scene scene = strong_breakwater(1e5);
  scene.loads["impulse"].history = triangle(1e5, 20.);
  scene.time.end = 20.;
  const SlipCircles c = *simulation_of(scene).run().summary.circles;
  ASSERT_TRUE(c.static_design && c.still && c.dynamic_load_factor);
  EXPECT_NEAR(c.static_design->factor, c.still->factor, 0.01 * c.still->factor);
  EXPECT_NEAR(*c.dynamic_load_factor, 1., 0.02);
  const SlipCircles& fast = *summary_of(1e6).circles;
  EXPECT_GT(std::abs(*fast.dynamic_load_factor - 1.), 0.05);
}

TEST(Circles, BearASurchargeWhereItLies) {
  Scene scene = strong_breakwater(1e5);
  const auto factor = [&](double from, double to) {
    scene.initial->surcharge["armour"] = {"mound_surface", 30e3, from, to};
    return simulation_of(scene).run().summary.circles->at_rest->factor;
  };
  const double none = summary_of(1e5).circles->at_rest->factor;
  EXPECT_GT(factor(-40., 40.), 1.01 * none) << "where the ground is pushed up on both sides";
  EXPECT_NEAR(factor(9., 40.), none, 1e-3 * none) << "it still slips to the other";
}

TEST(Circles, AreLessSafeUnderALargerLoadAndAsSafeAtRest) {
  const SlipCircles &small = *summary_of(1e5).circles, &large = *summary_of(2e5).circles;
  EXPECT_NEAR(small.at_rest->factor, large.at_rest->factor, 1e-9);
  EXPECT_LT(large.still->factor, small.still->factor);
}

TEST(Circles, AreJudgedByTheirLimit) {
  const Simulation simulation = simulation_of(strong_breakwater(1e5));
  Summary s = summary_of(1e5);
  Scene scene = simulation.scene();
  scene.limits.circles = 0.9 * s.circles->governs->factor;
  const auto judged = [&] {
    s.checks = checks_of(scene, s, {});
    return check_named(s, "slip circles")->holds;
  };
  EXPECT_EQ(judged(), true);
  scene.limits.circles = 1.1 * s.circles->governs->factor;
  EXPECT_EQ(judged(), false);
  s.circles->leaves_time = 0.1;
  scene.limits.circles = 0.1;
  EXPECT_EQ(judged(), false);
}

TEST(Circles, AreNotLookedForWithoutStrength) {
  Scene scene = strong_breakwater(1e5);
  for (const char* region : {"seabed", "mound"}) scene.regions[region].strength.reset();
  scene.limits.circles = 1.;
  const Summary s = simulation_of(scene).run().summary;
  EXPECT_FALSE(s.circles);
  EXPECT_EQ(s.why_no_circles, "no region has a table strength");
  EXPECT_TRUE(warns(s, "circles_open"));
  ASSERT_TRUE(check_named(s, "slip circles"));
  EXPECT_EQ(check_named(s, "slip circles")->why_not, "no region has a table strength");
}

TEST(Circles, CutNoRegionWithoutStrength) {
  Scene scene = strong_breakwater(1e5);
  scene.regions["seabed"].strength.reset();
  const Summary s = simulation_of(scene).run().summary;
  ASSERT_TRUE(s.circles && s.circles->governs);
  EXPECT_EQ(s.circles->uncut, "seabed");
  EXPECT_GT(s.circles->governs->factor, summary_of(1e5).circles->governs->factor);
}

TEST(Circles, WarnOfAFactorBelowOne) {
  Scene scene = strong_breakwater(1e5);
  scene.regions["seabed"].strength = Strength{5., 0.};
  scene.regions["mound"].strength = Strength{10., 0.};
  const Summary s = simulation_of(scene).run().summary;
  ASSERT_TRUE(s.circles && s.circles->governs);
  EXPECT_LT(s.circles->governs->factor, 1.);
  EXPECT_TRUE(warns(s, "slip_circle"));
}

}  // namespace circles_test
}  // namespace upbead::test
