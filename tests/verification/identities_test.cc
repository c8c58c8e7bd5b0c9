// Claims: both routes to F_T agree, and energy is accounted for, to round-off, where the scheme satisfies the equation
// of motion; a slow force passes through the caisson unchanged. Source: docs/theory.md (the semi-discrete system).
// Limits: 1e-8 for the identities (measured about 1e-12), 3 % for the slow triangle of 6 s.

#include <gtest/gtest.h>

#include "scenes.h"
#include "upbead/response/shear_response.h"

namespace upbead::test {
namespace {

class Identities : public ::testing::TestWithParam<std::tuple<SchemeKind, RegionKind>> {};

TEST_P(Identities, BothRoutesToShearForceAndTheEnergyBalance) {
  const auto [scheme, caisson_kind] = GetParam();
  Scene scene = breakwater(triangle(1.6e6, 0.15));
  if (caisson_kind == RegionKind::solid) {
    Region& caisson = scene.regions["caisson"];
    caisson.kind = RegionKind::solid;
    caisson.youngs_modulus = 30e9;
    caisson.poissons_ratio = 0.2;
  }
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, 0.5, 0.0125, scheme);
  const ShearResponse shear = read_shear_response(compiled.scene, response, true);
  EXPECT_LE(shear.reaction_mismatch, 1e-8);
  EXPECT_LE(response.energy.back().mismatch(), 1e-8);
  EXPECT_GT(shear.peak_shear, 0.1e6);
  EXPECT_NEAR(shear.impulse, 0.5 * 1.6e6 * 0.15, 1.);
  EXPECT_NEAR(*shear.arm, 8., 1e-9);
}

INSTANTIATE_TEST_SUITE_P(SchemesAndCaissons, Identities,
                         ::testing::Combine(::testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha),
                                            ::testing::Values(RegionKind::rigid, RegionKind::solid)));

TEST(SlowForce, PassesThroughTheCaisson) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1.6e6, 6.)), *mesh);
  const Response response = run(compiled, 8., 0.02);
  EXPECT_NEAR(read_shear_response(compiled.scene, response, true).shear_to_force_ratio, 1., 0.03);
}

}  // namespace
}  // namespace upbead::test
