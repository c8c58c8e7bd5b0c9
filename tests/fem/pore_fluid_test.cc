// Claim: an intrinsic permeability gives the hydraulic conductivity for the water's viscosity, and air in the pores
// makes the water as compressible as bubbles under the still-water pressure in the middle of the region do.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"
#include "upbead/fem/resolve.h"

namespace upbead::test {
namespace pore_fluid_test {

TEST(PoreFluid, PermeabilityIsAConductivity) {
  const auto mesh = breakwater_mesh(0.5);
  Scene scene = breakwater(triangle(1e6, 0.15));
  scene.gravity = 9.8;
  scene.fluid.density = 1025.;
  scene.fluid.viscosity = 1.2e-3;
  const double k = 0.13;
  Region& mound = scene.regions.at("mound");
  mound.hydraulic_conductivity = k;
  const Material by_conductivity = material(mound, scene.fluid, scene.gravity);
  mound.hydraulic_conductivity.reset();
  mound.permeability = k * 1.2e-3 / (1025. * 9.8);  // Bear (1972), eq. 5.5.9
  const Region resolved = resolve(scene, *mesh).scene.regions.at("mound");
  EXPECT_NEAR(*resolved.hydraulic_conductivity, k, 1e-12 * k);
  EXPECT_NEAR(material(mound, scene.fluid, scene.gravity).b, by_conductivity.b, 1e-12 * by_conductivity.b);
  EXPECT_NEAR(material(resolved, scene.fluid, scene.gravity).b, by_conductivity.b, 1e-12 * by_conductivity.b);
}

TEST(PoreFluid, AirMakesItSofterTheLessTheDeeper) {
  const auto mesh = breakwater_mesh(0.5);
  Scene scene = breakwater(triangle(1e6, 0.15));
  double low = 1e9, high = -1e9;
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    if (mesh->surface_of(cell) == "seabed")
      for (const unsigned v : cell->vertex_indices()) {
        low = std::min(low, cell->vertex(v)[1]);
        high = std::max(high, cell->vertex(v)[1]);
      }
  Region& sand = scene.regions.at("seabed");
  const double n = *sand.porosity, S = 0.97;
  const auto stored = [&](double level) {
    scene.initial.emplace().water_level = level;
    return material(resolve(scene, *mesh).scene.regions.at("seabed"), scene.fluid, scene.gravity).storage;
  };
  const double full = stored(15.);
  EXPECT_NEAR(full, n / scene.fluid.bulk_modulus, 1e-12 * full);
  sand.saturation = S;
  for (const double level : {15., 30.}) {
    const double p = 101325. + scene.fluid.density * scene.gravity * (level - 0.5 * (low + high));
    const double expected = n * (S / scene.fluid.bulk_modulus + (1. - S) / p);
    EXPECT_NEAR(stored(level), expected, 1e-9 * expected);
    EXPECT_GT(expected, 10. * full);
  }
  EXPECT_LT(stored(30.), stored(15.));
}

}  // namespace pore_fluid_test
}  // namespace upbead::test
