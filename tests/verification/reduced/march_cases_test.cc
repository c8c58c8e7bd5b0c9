// Claim: F_T of a reduced model is that of a march within the tolerance, in every kind of scene: dry, with pores and
// sea, undamped, absorbing, with an elastic caisson, with incompressible fluids, after a jump, under a rough record,
// under a pressure that enters the pores, under several loads separately.
// Source: SDIRK of order 4 with 64 steps per duration. Limits: the tolerance of 0.5 %.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "reduced_case.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace march_cases_test {

constexpr double duration = 0.15, density_of_cells = 0.5;
constexpr Limits asked_for{0.005, 0.005};

TimeFunction hit() {
  return triangle(1.6e6, duration);
}

Scene undamped(Scene scene) {
  for (const char* region : {"seabed", "mound"}) scene.regions[region].damping.reset();
  return scene;
}

TEST(ReducedMarch, Dry) {
  Record record("reduced_march");
  const auto mesh = breakwater_mesh(density_of_cells);
  compare(record, "dry", dry_scene(hit()), *mesh, asked_for);
  compare(record, "dry and undamped", undamped(dry_scene(hit())), *mesh, asked_for);
}

TEST(ReducedMarch, Sea) {
  Record record("reduced_march");
  const auto mesh = breakwater_mesh(density_of_cells, with_sea());
  compare(record, "compressible sea", sea_scene(hit()), *mesh, asked_for);
  const Scene incompressible = sea_scene(hit(), Compressibility::incompressible);
  compare(record, "incompressible sea", incompressible, *mesh, asked_for);
  compare(record, "sea and undamped soil", undamped(incompressible), *mesh, asked_for);
  Scene all = incompressible;
  all.fluid.bulk_modulus = std::numeric_limits<double>::infinity();
  compare(record, "all water incompressible", all, *mesh, asked_for);
}

TEST(ReducedMarch, AbsorbingSides) {
  Record record("reduced_march");
  const auto mesh = breakwater_mesh(density_of_cells, with_sea());
  Scene scene = sea_scene(hit(), Compressibility::incompressible);
  for (const char* side : {"left", "right"}) scene.boundaries[side].displacement = DisplacementCondition::absorbing;
  compare(record, "absorbing sides", scene, *mesh, asked_for);
  scene.boundaries["base"].displacement = DisplacementCondition::absorbing;
  compare(record, "absorbing sides and base", scene, *mesh, asked_for);
}

TEST(ReducedMarch, ElasticCaisson) {
  Record record("reduced_march");
  Scene scene = sea_scene(hit(), Compressibility::incompressible);
  Region& caisson = scene.regions["caisson"];
  caisson.kind = RegionKind::solid;
  caisson.shear_modulus = 1e9;
  caisson.poissons_ratio = 0.2;
  caisson.deformation = Deformation::elastic;
  compare(record, "elastic caisson", scene, *breakwater_mesh(density_of_cells, with_sea()), asked_for);
}

TEST(ReducedMarch, Step) {
  Record record("reduced_march");
  Pulse pulse;
  pulse.shape = PulseShape::step;
  pulse.peak = 1e6;
  const Scene scene = sea_scene(time_function(pulse), Compressibility::incompressible);
  compare(record, "a step of force", scene, *breakwater_mesh(density_of_cells, with_sea()), asked_for, 1. / 800.);
}

TEST(ReducedMarch, RoughRecord) {
  Record record("reduced_march");
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0., 0.01);
  std::vector<double> time, value;
  for (int i = 0; i <= 150; ++i) {
    time.push_back(0.002 * i);
    value.push_back(i == 0 || i == 150 ? 0. : 1.6e6 * (hit()(time.back()) / 1.6e6 + noise(random)));
  }
  Scene scene = sea_scene(piecewise_linear(time, value), Compressibility::incompressible);
  ASSERT_TRUE(is_rough(scene.loads["impulse"].history));
  scene.loads["impulse"].duration = sampled_duration(time, value, scene.time.end);
  // Steps of half a sampling interval: the record is straight in each.
  compare(record, "a rough record", scene, *breakwater_mesh(density_of_cells, with_sea()), asked_for, 0.001);
}

TEST(ReducedMarch, PressureInThePores) {
  Record record("reduced_march");
  Scene scene = breakwater(hit());
  Load load;
  load.boundary = "bed";
  load.kind = LoadKind::pressure;
  load.history = triangle(8e4, 2. * duration);
  scene.loads = {{"pressure", load}};
  scene.time.end = 0.5;
  // A symmetric section would have no F_T.
  const auto mesh = breakwater_mesh(density_of_cells, {{"seabed_front", 60.}, {"mound_crest_front", 30.}});
  // Pressure enters the sand through a skin of a few centimetres, for which moments about one frequency converge
  // slowly: the model does not reach 0.5 %, and reports that.
  const Compiled compiled(scene, *mesh);
  EXPECT_THROW(require_converged(reduce_scene(compiled.resolved, compiled.scene, {true, false, {}})), NumericsError);
  scene.tolerance = 0.03;
  compare(record, "pressure on the open bed", scene, *mesh, {0.03, 0.03});
}

/// The scene's system with one load alone.
System alone(const System& system, std::size_t k) {
  System copy = system;
  for (std::size_t other = 0; other < copy.loads.size(); ++other)
    if (other != k) copy.loads[other].history = TimeFunction();
  return copy;
}

TEST(ReducedMarch, EveryLoadAlone) {
  Record record("reduced_march");
  Scene scene = sea_scene(hit(), Compressibility::incompressible);
  Load high = scene.loads["impulse"];
  high.shape = {{10., 0.}, {20., 1.}};
  high.history = triangle(8e5, 0.2, 0.05);
  Load uplift;
  uplift.region = "caisson";
  uplift.at = {-3., 6.};
  uplift.direction = {0., 1.};
  uplift.history = triangle(9e5, 0.25);
  scene.loads["high"] = high;
  scene.loads["uplift"] = uplift;
  const auto mesh = breakwater_mesh(density_of_cells, with_sea());
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const Reduction reduction = reduce_scene(compiled.resolved, compiled.scene, {true, true, {}});
  ASSERT_TRUE(reduction.converged);
  EXPECT_EQ(reduction.n_independent_loads, 3);
  write_down(record, "three loads together", error_against(reduction.model, system, scene.time.end, duration / 64.),
             asked_for);
  for (std::size_t k = 0; k < system.loads.size(); ++k)
    write_down(record, "three loads, " + system.loads[k].name + " alone",
               error_against(reduction.model, alone(system, k), scene.time.end, duration / 64.), asked_for);
  record.measured("three loads: vectors per load", reduction.n_vectors / 3.);
}

}  // namespace march_cases_test
}  // namespace upbead::test
