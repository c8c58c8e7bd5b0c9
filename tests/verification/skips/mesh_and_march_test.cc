// Claims: leaving out cells that no wave reaches, water that touches nothing, the rest of a run without energy, and
// readings that were not asked for changes peak F_T by less than 0.1 %; each step size is factorised once.
// Source: the same scene solved in full.

#include <gtest/gtest.h>

#include "skip_case.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace mesh_and_march_test {

/// Without pore water waves are slow: 240 m/s in the sand.
Scene dry_scene(double end) {
  Scene scene = section_scene(false, 0.15);
  for (const char* region : {"seabed", "mound"}) {
    scene.regions[region].flow = Flow::drained;
    scene.regions[region].hydraulic_conductivity.reset();
  }
  for (auto& [name, side] : scene.boundaries) side.pressure.reset();
  scene.time.end = end;
  return scene;
}

TEST(Skips, CellsOutOfReach) {
  Scene scene = dry_scene(0.6);
  const auto mesh = breakwater_mesh(0.5, {{"seabed_front", 200.}, {"seabed_back", 200.}});
  const Solved chosen = solve(scene, *mesh, 0.15);
  ASSERT_EQ(decided(chosen, "", "full_domain"), "false");
  scene.mesh.full_domain = true;
  const Solved whole = solve(scene, *mesh, 0.15);
  EXPECT_LT(chosen.unknowns, 0.9 * whole.unknowns);
  Record record("skips");
  compare(record, "cells out of reach", chosen, whole);
}

TEST(Kept, CellsThatFieldsShow) {
  Scene scene = dry_scene(0.6);
  scene.fields_every = 0.1;
  EXPECT_TRUE(resolve(scene, *breakwater_mesh(0.5, {{"seabed_front", 200.}})).absent.empty());
}

TEST(Skips, WaterThatTouchesNothing) {
  // A caisson of 4 m on 4 m of ground, and a basin of water beside it, behind a gap.
  const auto place = [](const dealii::Point<dim>& at) -> std::string {
    if (at[0] > 8.) return "basin";
    if (at[0] > 6.) return "";
    if (at[1] < 4.) return "ground";
    return at[0] > 1. && at[0] < 5. ? "caisson" : "";
  };
  const auto mesh =
      tensor_mesh(even_lines(0., 12., 12), even_lines(0., 8., 8), place, [](const dealii::Point<dim>& at) {
        return std::string(at[0] > 7. ? "shore" : at[1] < 1e-6 ? "base" : at[0] == 1. && at[1] > 4. ? "front" : "free");
      });
  Scene scene = dry_scene(0.3);
  scene.regions["ground"] = scene.regions["seabed"];
  scene.regions.erase("seabed");
  scene.regions.erase("mound");
  scene.regions["basin"].kind = RegionKind::water;
  const Boundary base = scene.boundaries["base"];
  scene.boundaries.clear();
  scene.boundaries["base"] = base;
  scene.boundaries["front"] = scene.boundaries["free"] = {};
  scene.boundaries["shore"].pressure = PressureCondition::open;
  ResolvedScene resolved = resolve(scene, *mesh);
  ASSERT_FALSE(resolved.absent.empty());
  const Compiled without(resolved, *mesh);
  resolved.absent.clear();
  const Compiled with(resolved, *mesh);
  EXPECT_LT(without.system.size(), with.system.size());
  const auto peak = [](const Compiled& compiled) { return shear_of(compiled, run(compiled, 0.3, 0.0125)).peak_shear; };
  EXPECT_NEAR(peak(without), peak(with), 1e-9 * peak(with));
}

TEST(Skips, TheEndOnceLittleEnergyIsLeft) {
  const Scene scene = section_scene(true, 0.15);
  const auto mesh = breakwater_mesh(0.5, with_sea());
  const Compiled compiled(scene, *mesh);
  const auto marched = [&](double share) {
    const auto scheme = make_scheme(compiled.system, {});
    MarchOptions options;
    options.stop_at_energy = share;
    return march(compiled.system, *scheme, make_time_grid(kinks(compiled.system), 6., 0.0125), options);
  };
  const Response whole = marched(0.), cut = marched(0.3);
  EXPECT_TRUE(cut.stopped_early);
  EXPECT_LT(cut.n_steps, 0.7 * whole.n_steps);
  const double peak = shear_of(compiled, whole).peak_shear;
  EXPECT_NEAR(shear_of(compiled, cut).peak_shear, peak, 1e-3 * peak);
}

TEST(Skips, ReadingsThatNobodyAskedFor) {
  Scene scene = section_scene(true, 0.15);
  const auto mesh = breakwater_mesh(0.5, with_sea());
  const Compiled bare(scene, *mesh);
  for (const Reading& reading : bare.system.readings) EXPECT_NE(reading.name.group, "probes");
  scene.probes["A"].at = {0., -5.};
  const Compiled probed(scene, *mesh);
  EXPECT_GT(probed.system.readings.size(), bare.system.readings.size());
  EXPECT_EQ(history(bare, run(bare, 0.3, 0.0125), "shear_force"),
            history(probed, run(probed, 0.3, 0.0125), "shear_force"));
}

TEST(Skips, FactorisationsOfAStepSizeItHas) {
  const Scene scene = section_scene(true, 0.15);
  const auto mesh = breakwater_mesh(0.5, with_sea());
  const Compiled compiled(scene, *mesh);
  for (const SchemeKind kind : {SchemeKind::sdirk4, SchemeKind::generalised_alpha}) {
    SchemeOptions options;
    options.kind = kind;
    const auto scheme = make_scheme(compiled.system, options);
    const TimeGrid grid = make_time_grid(kinks(compiled.system), 0.5, 0.0125);
    march(compiled.system, *scheme, grid);
    EXPECT_EQ(scheme->n_factorisations(), grid.n_step_sizes());
  }
}

}  // namespace mesh_and_march_test
}  // namespace upbead::test
