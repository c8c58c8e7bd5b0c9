// Claims: in a run the amplitude of shear is that of statics in a column, the same by a reduced model and by a march,
// and in proportion to the height; stones and open sides drain; a body on ground that shrinks evenly settles by its
// strain times its thickness and does not tilt; checks are judged by their limits, where soil liquefies settlement has
// no bound; clay builds nothing; where nothing can be told it is said why, and where nothing is asked nothing is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/settling.h"
#include "findings/find.h"
#include "output/output_schema.h"
#include "response/cyclic_shear.h"
#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace cycles_test {

/// A breakwater on sand whose storm has three parts; the run's wave is the highest.
Scene stormy_scene(double peak) {
  Scene scene = breakwater(triangle(peak, 0.4));
  scene.initial.emplace().water_level = 6.;
  scene.initial->k0 = 0.5;
  scene.regions["seabed"].cyclic = CyclicSoil{0.6, {}, {}};
  scene.time.end = 0.8;
  scene.time.scheme = TimeScheme::reduced;
  Cycles& cycles = scene.cycles.emplace();
  cycles.number = {300., 100., 200.};
  cycles.period = {9., 11., 9.};
  cycles.height = {2., 5., 3.};
  cycles.run_height = 5.;
  return scene;
}

Simulation simulation_of(const Scene& scene) {
  return Simulation(scene, breakwater_mesh(0.5));
}

Summary summary_of(const Scene& scene) {
  return simulation_of(scene).run().summary;
}

const Summary& gentle() {
  static const Summary found = summary_of(stormy_scene(1e5));
  return found;
}

const Check* check_named(const Summary& summary, const std::string& name) {
  for (const Check& check : summary.checks)
    if (check.name == name) return &check;
  return nullptr;
}

bool warns(const Summary& summary, const std::string& code) {
  return std::any_of(summary.warnings.begin(), summary.warnings.end(),
                     [&](const NumberedWarning& w) { return w.name == code; });
}

TEST(Cycles, AreToldOfAStorm) {
  ASSERT_TRUE(gentle().cycles);
  const CyclesSummary& c = *gentle().cycles;
  EXPECT_EQ(c.waves, 600.);
  EXPECT_NEAR(c.duration, 300. * 9. + 100. * 11. + 200. * 9., 1e-9);
  EXPECT_GT(c.largest_ratio, 0.);
  EXPECT_LT(c.largest_ratio, 1.);
  EXPECT_NEAR(c.water.error, 0., 1e-9);
  EXPECT_EQ(c.cells_liquefied, 0);
  EXPECT_FALSE(c.first_liquefied);
  ASSERT_EQ(c.regions.size(), 1u);
  EXPECT_EQ(c.regions[0].region, "seabed");
  EXPECT_NEAR(c.regions[0].alpha, 0.34 * 0.6 + 0.084, 1e-12);
  EXPECT_NEAR(c.regions[0].beta, 0.37 * 0.6 - 0.46, 1e-12);
  EXPECT_NEAR(c.regions[0].largest_ratio, c.largest_ratio, 1e-12);
  ASSERT_TRUE(c.by_compaction && c.by_drainage);
  EXPECT_GT(c.by_compaction->settlement, 0.);
  EXPECT_GT(c.by_drainage->settlement, 0.);
  EXPECT_EQ(gentle().why_no_cycles, "");
}

TEST(Cycles, AreTheSameByAMarch) {
  Scene scene = stormy_scene(1e5);
  scene.time.scheme = TimeScheme::sdirk4;
  const Summary marched = summary_of(scene);
  ASSERT_TRUE(marched.cycles);
  const CyclesSummary &a = *gentle().cycles, &b = *marched.cycles;
  EXPECT_NEAR(a.regions[0].largest_shear, b.regions[0].largest_shear, 0.01 * b.regions[0].largest_shear);
  EXPECT_NEAR(a.by_compaction->settlement, b.by_compaction->settlement, 0.01 * b.by_compaction->settlement);
  for (std::size_t i = 0; i < a.fields->shear.size(); ++i) {
    if (std::isnan(a.fields->shear[i])) continue;
    EXPECT_NEAR(a.fields->shear[i], b.fields->shear[i], 0.01 * b.regions[0].largest_shear);
  }
}

TEST(Cycles, ShearInProportionToTheHeight) {
  Scene scene = stormy_scene(2e5);
  for (double& height : scene.cycles->height) height *= 0.5;
  const Summary half = summary_of(scene);
  ASSERT_TRUE(half.cycles);
  const CyclesSummary &a = *gentle().cycles, &b = *half.cycles;
  EXPECT_NEAR(b.regions[0].largest_shear, 2. * a.regions[0].largest_shear, 1e-6 * b.regions[0].largest_shear);
  EXPECT_NEAR(b.largest_ratio, a.largest_ratio, 1e-6 * a.largest_ratio);
  EXPECT_NEAR(b.by_drainage->settlement, a.by_drainage->settlement, 1e-6 * a.by_drainage->settlement);
}

TEST(Cycles, AreJudgedByTheirLimits) {
  Scene scene = stormy_scene(1e5);
  Summary s = gentle();
  s.response->peak_force_seaward = -s.response->peak_force;  // with its trough
  const auto judged = [&](const char* name) {
    s.checks = checks_of(scene, s, {});
    return check_named(s, name)->holds;
  };
  EXPECT_FALSE(judged("residual pore pressure"));
  scene.limits.pressure_ratio = 1.1 * s.cycles->largest_ratio;
  scene.limits.settlement = 1.1 * s.cycles->by_compaction->settlement;
  scene.limits.tilt = 0.9 * std::abs(s.cycles->by_compaction->tilt);
  EXPECT_EQ(judged("residual pore pressure"), true);
  EXPECT_EQ(judged("settlement in the storm"), true);
  EXPECT_EQ(judged("tilt in the storm"), std::nullopt) << "the section is its own mirror image";
  s.cycles->by_compaction->tilt = -1e-3;
  scene.limits.tilt = 0.9e-3;
  EXPECT_EQ(judged("tilt in the storm"), false);
  s.cycles->by_compaction.reset();
  scene.limits.settlement = 0.9 * s.cycles->by_drainage->settlement;
  EXPECT_EQ(judged("settlement in the storm"), false);
  EXPECT_EQ(check_named(s, "settlement in the storm")->measure, "cycles.by_drainage.settlement");
  s.cycles->why_no_settling = "there is no caisson";
  EXPECT_EQ(judged("settlement in the storm"), std::nullopt);
}

TEST(Cycles, WarnOfLiquefiedSoil) {
  Scene scene = stormy_scene(2e6);
  scene.regions["seabed"].hydraulic_conductivity = 1e-6;
  scene.limits.settlement = 10.;
  const Summary s = summary_of(scene);
  ASSERT_TRUE(s.cycles);
  EXPECT_GT(s.cycles->cells_liquefied, 0);
  EXPECT_GT(s.cycles->water.shed, 0.);
  EXPECT_NEAR(s.cycles->water.error, 0., 1e-9);
  ASSERT_TRUE(s.cycles->first_liquefied);
  EXPECT_EQ(s.cycles->largest_ratio, 1.);
  EXPECT_NE(s.cycles->why_no_settling, "");
  EXPECT_FALSE(s.cycles->by_compaction || s.cycles->by_drainage);
  EXPECT_TRUE(warns(s, "liquefied"));
  EXPECT_EQ(check_named(s, "settlement in the storm")->holds, false);
}

TEST(Cycles, AreNotToldWithoutReason) {
  Scene none = stormy_scene(1e5);
  none.cycles.reset();
  const Summary plain = summary_of(none);
  EXPECT_FALSE(plain.cycles);
  EXPECT_EQ(plain.why_no_cycles, "");
  EXPECT_FALSE(check_named(plain, "residual pore pressure"));
  Scene clay = stormy_scene(1e5);
  clay.regions["seabed"].cyclic.reset();
  clay.limits.pressure_ratio = 0.5;
  const Summary of_clay = summary_of(clay);
  EXPECT_FALSE(of_clay.cycles);
  EXPECT_EQ(of_clay.why_no_cycles, "no region has a table cyclic");
  EXPECT_TRUE(warns(of_clay, "cycles_open"));
  EXPECT_EQ(check_named(of_clay, "residual pore pressure")->why_not, "no region has a table cyclic");
  Scene dry = stormy_scene(1e5);
  dry.initial.reset();
  EXPECT_EQ(summary_of(dry).why_no_cycles, "no still water level is known: give [initial] water_level");
}

TEST(Cycles, BuildNothingInClay) {
  Scene scene = stormy_scene(1e5);
  scene.regions["subsoil"] = scene.regions["seabed"];
  scene.regions["subsoil"].cyclic.reset();
  scene.regions["subsoil"].hydraulic_conductivity = 1e-9;
  const Simulation simulation(scene, breakwater_mesh(0.5, {{"seabed_depth", 4.}, {"subsoil_depth", 6.}}));
  const Summary s = simulation.run().summary;
  ASSERT_TRUE(s.cycles);
  ASSERT_EQ(s.cycles->regions.size(), 1u);
  const Mesh& mesh = *simulation.mesh();
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell) == "subsoil") {
      EXPECT_TRUE(std::isnan(s.cycles->fields->shear[cell->active_cell_index()]));
      EXPECT_TRUE(std::isnan(s.cycles->fields->compaction[cell->active_cell_index()]));
      EXPECT_LE(s.cycles->fields->drained[cell->active_cell_index()], 0.);
    }
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell) == "mound") {
      EXPECT_LT(s.cycles->fields->pressure[cell->active_cell_index()], 1.);  // stones drain at once
    }
}

/// A wave without its trough has half of the amplitude of shear: it fails rightly, and holds nothing.
TEST(Cycles, OfACrestAloneHoldNothing) {
  EXPECT_TRUE(warns(gentle(), "cycles_one_sided"));
  Scene scene = stormy_scene(1e5);
  for (const bool holds : {true, false}) {
    const double share = holds ? 1.1 : 0.9;
    scene.limits.pressure_ratio = share * gentle().cycles->largest_ratio;
    scene.limits.settlement = share * gentle().cycles->by_compaction->settlement;
    Summary s = gentle();
    s.checks = checks_of(scene, s, {});
    for (const char* name : {"residual pore pressure", "settlement in the storm"})
      EXPECT_EQ(check_named(s, name)->holds, holds ? std::nullopt : std::optional(false)) << name;
  }
  scene.loads["impulse"].history = piecewise_linear({0., 0.2, 0.4, 0.6, 0.8}, {0., 1e5, 0., -1e5, 0.});
  EXPECT_FALSE(warns(summary_of(scene), "cycles_one_sided"));
}

/// Slowly loaded drained sand between rollers: s_x = nu/(1 - nu) s_y, so that the amplitude of a pulse q is
/// q (1 - 2 nu)/(4 (1 - nu)).
TEST(Cycles, HaveTheShearOfStatics) {
  Scene scene = column(sand(), triangle(20e3, 40.));
  scene.regions["soil"].cyclic = CyclicSoil{0.6, {}, {}};
  scene.regions["soil"].flow = Flow::drained;
  const auto mesh = column_mesh(4., 8);
  const Compiled compiled(scene, *mesh);
  CyclicShear shear(compiled.space, compiled.unknowns);
  const auto scheme = make_scheme(compiled.system, {});
  MarchOptions options;
  options.observers = {&shear};
  march(compiled.system, *scheme, make_time_grid(kinks(compiled.system), 40., 1.), options);
  const double nu = *scene.regions["soil"].poissons_ratio, expected = 20e3 * (1. - 2. * nu) / (4. * (1. - nu));
  for (const double value : shear.amplitude()) EXPECT_NEAR(value, expected, 0.01 * expected);
  const std::vector<double> memory = shear.memory();
  CyclicShear again(compiled.space, compiled.unknowns);
  again.recall(memory);
  EXPECT_EQ(again.amplitude(), shear.amplitude());
  EXPECT_TRUE(again.has_seen());
}

/// A rigid block over the whole width of two layers between rollers.
TEST(Cycles, SettleABodyByTheStrainBelow) {
  Scene scene;
  scene.regions["seabed"] = sand();
  scene.regions["mound"] = rubble();
  scene.regions["caisson"].kind = RegionKind::rigid;
  scene.regions["caisson"].density = 2100.;
  for (const char* side : {"left", "right"})
    scene.boundaries[side] = {DisplacementCondition::roller, PressureCondition::sealed};
  scene.boundaries["base"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  for (const char* side : {"front", "back", "top"}) scene.boundaries[side] = {};
  const auto mesh = tensor_mesh(
      even_lines(0., 6., 6), even_lines(0., 8., 16),
      [](const dealii::Point<dim>& at) {
        return std::string(at[1] > 6. ? "caisson" : at[1] > 5. ? "mound" : "seabed");
      },
      [](const dealii::Point<dim>& at) -> std::string {
        if (at[1] < 1e-9) return "base";
        if (at[1] > 8. - 1e-9) return "top";
        if (at[0] < 1e-9) return at[1] > 6. ? "front" : "left";
        if (at[0] > 6. - 1e-9) return at[1] > 6. ? "back" : "right";
        return "";
      });
  std::vector<double> even, skew;
  for (const auto& cell : mesh->triangulation.active_cell_iterators()) {
    const bool is_sand = mesh->surface_of(cell) == "seabed";
    even.push_back(is_sand ? 0.002 * cell->center()[1] : NAN);
    skew.push_back(is_sand ? 0.001 * cell->center()[0] : NAN);
  }
  const auto found = settled_caisson(scene, *mesh, {}, {even, skew});
  ASSERT_TRUE(found[0] && found[1]);
  EXPECT_NEAR(found[0]->down, 0.002 * 0.5 * 25., 1e-10);
  EXPECT_NEAR(found[0]->rotation, 0., 1e-10);
  EXPECT_NEAR(found[1]->down, 0.003 * 5., 1e-6);
  EXPECT_GT(found[1]->rotation, 0.);  // more strain landward: it tilts landward
}

TEST(Cycles, AreWrittenWithoutNumbersThatAreNotFinite) {
  EXPECT_NO_THROW(keys_of({}).text(gentle()));
}

}  // namespace cycles_test
}  // namespace upbead::test
