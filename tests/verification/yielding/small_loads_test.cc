// Claim: under small loads the response of soil that yields is that of linear soil, to 1e-6 of every reading:
// hysteretic soil that was never loaded, and Mohr-Coulomb soil whose stress at rest lies within its strength. From
// the starts k0 and gravity hysteretic soil yields from the first strain on, under the smallest load, as some of its
// elements have yielded at rest: the difference is recorded.
#include <cmath>

#include "tensor_mesh.h"
#include "yielding_march.h"

namespace upbead::test {
namespace small_loads_test {

constexpr double end = 0.6;

/// The prototype of the tests, in 15 m of water.
Scene prototype() {
  Scene scene = breakwater(triangle(1., 0.15));
  scene.probes["sand"].at = {4., -3.};
  scene.initial = InitialState{15., {}};
  return scene;
}

/// Another section: a block on a thin bed of rubble over stiff sand over soft clay, sides and base that absorb waves,
/// no pore water in the rubble, no damping.
Scene layered() {
  Scene scene;
  Region clay = sand(), stiff = sand(), bed = rubble(), block;
  clay.shear_modulus = 12e6;
  clay.hydraulic_conductivity = 1e-8;
  stiff.shear_modulus = 80e6;
  for (Region* soil : {&clay, &stiff, &bed}) soil->damping.reset();
  block.kind = RegionKind::rigid;
  block.density = 2000.;
  scene.regions = {{"clay", clay}, {"stiff", stiff}, {"bed", bed}, {"caisson", block}};
  for (const char* side : {"left", "right", "base"})
    scene.boundaries[side] = {DisplacementCondition::absorbing, PressureCondition::sealed};
  scene.boundaries["walls"] = {};
  for (const char* side : {"ground", "bed_sides"})
    scene.boundaries[side] = {DisplacementCondition::free, PressureCondition::open};
  Load load;
  load.region = caisson_name;
  load.at = {0., 9.};
  load.history = triangle(1., 0.08, 0.02);
  scene.loads["impact"] = load;
  scene.probes["sand"].at = {1.5, -1.5};
  scene.initial = InitialState{-20., {}};
  return scene;
}

std::unique_ptr<Mesh> layered_mesh() {
  const auto surface = [](const dealii::Point<dim>& p) -> std::string {
    if (p[1] < -4.) return "clay";
    if (p[1] < 0.) return "stiff";
    if (std::abs(p[0]) < 8. && p[1] < 2.) return "bed";
    return std::abs(p[0]) < 6. && p[1] > 2. ? "caisson" : "";
  };
  const auto curve = [](const dealii::Point<dim>& p) -> std::string {
    if (p[1] < -12. + 1e-9) return "base";
    if (p[0] < -40. + 1e-9) return "left";
    if (p[0] > 40. - 1e-9) return "right";
    if (std::abs(p[1]) < 1e-9 && std::abs(p[0]) > 8.) return "ground";
    if (p[1] > 2. + 1e-9) return "walls";
    if (p[1] > 1e-9 && (std::abs(p[0]) > 8. - 1e-9 || (p[1] > 2. - 1e-9 && std::abs(p[0]) > 6.))) return "bed_sides";
    return "";
  };
  return tensor_mesh(even_lines(-40., 40., 40), joined(even_lines(-12., 2., 7), even_lines(2., 14., 4)), surface,
                     curve);
}

void yield_by(Scene& scene, SoilLaw law, double cohesion, RestStart start) {
  for (auto& [name, region] : scene.regions) {
    if (region.kind != RegionKind::porous) continue;
    region.law = law;
    region.strength = Strength{35., cohesion, 0., cohesion};
  }
  scene.initial->start = start;
}

/// The largest difference of a reading, over its largest value; the caisson's settlement vanishes by symmetry.
double largest_difference(const YieldingMarch& a, const YieldingMarch& b) {
  double worst = 0.;
  for (const char* reading :
       {"shear_force", "caisson/displacement_x", "caisson/rotation", "probes/sand/displacement_x",
        "probes/sand/effective_stress_xy", "probes/sand/effective_stress_yy", "probes/sand/pressure"}) {
    const auto own = a.history(reading), other = b.history(reading);
    worst = std::max(worst, (own - other).cwiseAbs().maxCoeff() / other.cwiseAbs().maxCoeff());
  }
  return worst;
}

class SmallLoads : public ::testing::TestWithParam<bool> {};

TEST_P(SmallLoads, AreAnsweredAsByLinearSoil) {
  const Scene scene = GetParam() ? layered() : prototype();
  const double step = GetParam() ? 0.0075 : 0.015;  // about a tenth of the pulse
  const auto mesh = GetParam() ? layered_mesh() : breakwater_mesh(0.5);
  const std::string where = GetParam() ? "layers with absorbing sides, " : "prototype, ";
  const auto marched = [&](SoilLaw law, double cohesion, RestStart start) {
    Scene own = scene;
    yield_by(own, law, cohesion, start);
    return YieldingMarch(own, *mesh, end, step);
  };
  const YieldingMarch linear = marched(SoilLaw::mohr_coulomb, 1e12, RestStart::k0);
  ASSERT_EQ(linear.energy().plastic, 0.);
  Record record("yielding_small");
  record.at_most(where + "hysteretic, never loaded",
                 largest_difference(marched(SoilLaw::hysteretic, 2e3, RestStart::virgin), linear), 1e-6);
  record.at_most(where + "Mohr-Coulomb, c' = 500 kPa",
                 largest_difference(marched(SoilLaw::mohr_coulomb, 500e3, RestStart::k0), linear), 1e-6);
  record.measured(where + "hysteretic from K_0",
                  largest_difference(marched(SoilLaw::hysteretic, 2e3, RestStart::k0), linear));
  // and the march without yield is that of linear soil: the same scene by another scheme in a quarter of the step
  Scene elastic = scene;
  const Compiled compiled(elastic, *mesh);
  const Response exact = run(compiled, end, 0.25 * step);
  const double peak = history(compiled, exact, "shear_force").maxCoeff();
  record.at_most(where + "peak of F_T of the march without yield against sdirk4 in a quarter of the step, relative",
                 std::abs(linear.history("shear_force").maxCoeff() / peak - 1.), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Both, SmallLoads, ::testing::Bool());

}  // namespace small_loads_test
}  // namespace upbead::test
