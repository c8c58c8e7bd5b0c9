// Claims: the program's choices for a region (flow, drainage, compressibility, rigidity) change peak F_T by less than
// 0.1 % against the full description, for values near the limits of the choices as well as far from them. Source: the
// same scene with the choice overruled.

#include <gtest/gtest.h>

#include "skip_case.h"

namespace upbead::test {
namespace decisions_test {

Solved with_flow(Scene scene, const Mesh& mesh, const std::string& region, Flow flow, double duration) {
  scene.regions[region].flow = flow;
  return solve(scene, mesh, duration);
}

TEST(Skips, InertialFlowInSand) {
  const double duration = 0.15;
  const Scene scene = section_scene(false, duration);
  const auto mesh = breakwater_mesh(0.5);
  const Solved chosen = solve(scene, *mesh, duration);
  ASSERT_EQ(decided(chosen, "seabed", "flow"), "darcy");
  ASSERT_EQ(decided(chosen, "mound", "flow"), "inertial");
  Record record("skips");
  compare(record, "inertial flow in sand", chosen, with_flow(scene, *mesh, "seabed", Flow::inertial, duration));
}

class NearTheLimitOfX : public testing::TestWithParam<double> {};

TEST_P(NearTheLimitOfX, DarcyFlowInTheMound) {
  const double duration = GetParam(), omega = 40. / duration;
  Record record("skips");
  for (const bool sea : {false, true}) {
    Scene scene = section_scene(sea, duration);
    scene.regions["mound"].hydraulic_conductivity = 0.99 * 0.15 * 9.81 * 0.4 / omega;
    const auto mesh = breakwater_mesh(0.5, sea ? with_sea() : std::map<std::string, double>{});
    const Solved chosen = solve(scene, *mesh, duration);
    ASSERT_EQ(decided(chosen, "mound", "flow"), "darcy");
    compare(record, std::string("inertial flow in the mound, X = 0.149, ") + (sea ? "sea" : "no sea"), chosen,
            with_flow(scene, *mesh, "mound", Flow::inertial, duration));
  }
}

INSTANTIATE_TEST_SUITE_P(Durations, NearTheLimitOfX, testing::Values(0.05, 0.15, 0.6, 3.));

TEST(Skips, PoresOfAMoundThatDrains) {
  const double duration = 24.;
  Record record("skips");
  for (const double k : {0.1, 0.3}) {
    Scene scene = section_scene(false, duration);
    scene.regions["mound"].hydraulic_conductivity = k;
    const auto mesh = breakwater_mesh(0.5);
    const Solved chosen = solve(scene, *mesh, duration);
    ASSERT_EQ(decided(chosen, "mound", "flow"), "drained");
    compare(record, "pores of a mound of k = " + std::to_string(k).substr(0, 3) + " m/s under a load of 24 s", chosen,
            with_flow(scene, *mesh, "mound", Flow::inertial, duration));
  }
}

TEST(Skips, CompressionOfTheSea) {
  Record record("skips");
  for (const double duration : {0.17, 0.5}) {
    Scene scene = section_scene(true, duration);
    const auto mesh = breakwater_mesh(0.5, with_sea());
    const Solved chosen = solve(scene, *mesh, duration);
    ASSERT_EQ(decided(chosen, "sea_front", "compressibility"), "incompressible");
    for (const char* sea : {"sea_front", "sea_back"})
      scene.regions[sea].compressibility = Compressibility::compressible;
    compare(record, "compression of the sea, " + std::to_string(duration).substr(0, 4) + " s", chosen,
            solve(scene, *mesh, duration));
  }
}

TEST(Skips, DeformationOfAConcreteCaisson) {
  Record record("skips");
  for (const double duration : {0.1, 0.5}) {
    Scene scene = section_scene(false, duration);
    Region& caisson = scene.regions["caisson"];
    caisson.kind = RegionKind::solid;
    caisson.shear_modulus = 12.5e9;
    caisson.poissons_ratio = 0.2;
    const auto mesh = breakwater_mesh(0.5);
    const Solved chosen = solve(scene, *mesh, duration);
    ASSERT_EQ(decided(chosen, "caisson", "deformation"), "rigid");
    caisson.deformation = Deformation::elastic;
    compare(record, "deformation of a concrete caisson, " + std::to_string(duration).substr(0, 3) + " s", chosen,
            solve(scene, *mesh, duration));
  }
}

TEST(Kept, WhereTheNumbersAskForIt) {
  Scene scene = section_scene(true, 0.05);
  Region& caisson = scene.regions["caisson"];
  caisson.kind = RegionKind::solid;
  caisson.shear_modulus = 1e9;
  caisson.poissons_ratio = 0.2;
  const ResolvedScene resolved = resolve(scene, *breakwater_mesh(0.5, with_sea()));
  EXPECT_EQ(resolved.scene.regions.at("mound").flow, Flow::inertial);
  EXPECT_EQ(resolved.scene.regions.at("sea_back").compressibility, Compressibility::compressible);
  EXPECT_EQ(resolved.scene.regions.at("caisson").kind, RegionKind::solid);
}

}  // namespace decisions_test
}  // namespace upbead::test
