// Claim: Biot's constants follow from the keys by their definitions; a region that lacks its keys or has keys of
// another kind is refused.
#include "upbead/model/region.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead {

namespace region_test {

Region rubble() {
  Region region;
  region.shear_modulus = 100e6;
  region.poissons_ratio = 0.3;
  region.porosity = 0.4;
  region.grain_density = 2650.;
  region.hydraulic_conductivity = 0.1;
  return region;
}

std::string keys_of(const Diagnostics& list) {
  std::string keys;
  for (const Diagnostic& found : list) keys += (keys.empty() ? "" : " ") + found.place.key;
  return keys;
}

TEST(RegionMaterial, OfPorousSoil) {
  Region region = rubble();
  region.tortuosity = 1.5;
  region.biot = 0.9;
  region.grain_bulk_modulus = 36e9;
  region.damping = Rayleigh{0.05, {1., 10.}};
  const Material m = material(region, Fluid{1000., 2e9}, 10.);
  EXPECT_DOUBLE_EQ(m.G, 100e6);
  EXPECT_DOUBLE_EQ(m.lambda, 150e6);
  EXPECT_DOUBLE_EQ(m.rho, 0.6 * 2650. + 400.);
  EXPECT_DOUBLE_EQ(m.rho_f, 1000.);
  EXPECT_DOUBLE_EQ(m.a, 1.5 * 1000. / 0.4);
  EXPECT_DOUBLE_EQ(m.b, 1e5);
  EXPECT_DOUBLE_EQ(m.alpha, 0.9);
  EXPECT_DOUBLE_EQ(m.storage, 0.4 / 2e9 + 0.5 / 36e9);
  // the damping ratio is met at both frequencies: zeta = mass_factor / (2 w) + stiffness_factor w / 2
  for (const double f : {1., 10.}) {
    const double w = 2. * M_PI * f;
    EXPECT_NEAR(m.mass_damping / (2. * w) + m.stiffness_damping * w / 2., 0.05, 1e-15);
  }
}

TEST(RegionMaterial, OfIncompressibleFluidAndGrains) {
  EXPECT_EQ(material(rubble(), Fluid{1000., std::numeric_limits<double>::infinity()}, 10.).storage, 0.);
}

TEST(RegionMaterial, OfSolidAndRigid) {
  Region solid;
  solid.kind = RegionKind::solid;
  solid.youngs_modulus = 26e9;
  solid.poissons_ratio = 0.3;
  solid.density = 2400.;
  const Material m = material(solid, {}, 9.81);
  EXPECT_DOUBLE_EQ(m.G, 10e9);
  EXPECT_DOUBLE_EQ(m.rho, 2400.);
  EXPECT_EQ(m.alpha, 0.);
  Region rigid;
  rigid.kind = RegionKind::rigid;
  rigid.density = 2100.;
  EXPECT_DOUBLE_EQ(material(rigid, {}, 9.81).rho, 2100.);
}

TEST(RegionCheck, WantsTheKeysOfItsKind) {
  EXPECT_EQ(keys_of(diagnose(rubble())), "");
  Region region;
  EXPECT_EQ(keys_of(diagnose(region)), "poissons_ratio porosity grain_density shear_modulus hydraulic_conductivity");
  region.kind = RegionKind::solid;
  EXPECT_EQ(keys_of(diagnose(region)), "poissons_ratio shear_modulus density");
  region.kind = RegionKind::rigid;
  EXPECT_EQ(keys_of(diagnose(region)), "density");
}

TEST(RegionCheck, DrainedSoilNeedsNoConductivity) {
  Region region = rubble();
  region.hydraulic_conductivity.reset();
  region.flow = Flow::drained;
  EXPECT_EQ(keys_of(diagnose(region)), "");
}

TEST(RegionCheck, RefusesTheKeysOfOtherKinds) {
  Region region = rubble();
  region.mass = 1.;
  region.density = 1.;
  EXPECT_EQ(keys_of(diagnose(region)), "density mass");
  region = rubble();
  region.kind = RegionKind::rigid;
  region.mass = 1.;
  region.flow = Flow::darcy;
  region.damping = Rayleigh{};
  EXPECT_EQ(keys_of(diagnose(region)),
            "shear_modulus poissons_ratio porosity grain_density hydraulic_conductivity flow damping");
}

TEST(RegionCheck, RefusesContradictions) {
  Region region = rubble();
  region.youngs_modulus = 1.;
  region.biot = 0.3;
  region.grain_bulk_modulus = 36e9;
  region.permeability = 1e-9;
  region.damping = Rayleigh{0.05, {10., 1.}};
  EXPECT_EQ(keys_of(diagnose(region)), "youngs_modulus permeability biot damping");
}

TEST(RegionKeys, BelongToKinds) {
  EXPECT_TRUE(belongs("kind", RegionKind::rigid));
  EXPECT_TRUE(belongs("porosity", RegionKind::porous));
  EXPECT_FALSE(belongs("porosity", RegionKind::solid));
}

}  // namespace region_test
}  // namespace upbead
