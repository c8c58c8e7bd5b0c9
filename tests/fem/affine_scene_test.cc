// Claims: the System of a scene with another soil equals the sum of its parts, to round-off: M, C, K, radiation and all
// readings, for each kind of region, side and flow, bonded and with an interface; and no part is without effect.
#include "fem/affine_scene.h"

#include <gtest/gtest.h>

#include <random>

#include "scenes.h"

namespace upbead::test {
namespace affine_scene_test {

using Regions = std::map<std::string, Region>;

/// Other constants of every region that deforms or flows, each moved by its own.
Regions other_soil(Regions regions, unsigned seed) {
  std::mt19937 random(seed);
  const auto by = [&random](double most) {
    return std::pow(most, std::uniform_real_distribution<double>(-1., 1.)(random));
  };
  for (auto& [name, r] : regions) {
    if (r.kind != RegionKind::porous && !(r.kind == RegionKind::solid && r.deformation == Deformation::elastic))
      continue;
    r.shear_modulus = *r.shear_modulus * by(3.);
    r.poissons_ratio = 0.25 + 0.1 * (by(2.) - 0.5);
    if (r.damping) r.damping->ratio *= by(2.);
    if (r.kind == RegionKind::solid) continue;
    r.hydraulic_conductivity = *r.hydraulic_conductivity * by(10.);
    r.porosity = *r.porosity * by(1.2);
    r.grain_density = *r.grain_density * by(1.05);
    r.biot = 1. - 0.1 * by(2.) / 2.;
    r.tortuosity = 1.5 * by(1.3);
    r.grain_bulk_modulus = 36e9 * by(1.5);
  }
  return regions;
}

std::map<std::string, Coefficients> coefficients_of(const Scene& scene, const Regions& regions) {
  std::map<std::string, Coefficients> all;
  for (const auto& [name, region] : regions) all[name] = coefficients(region, scene.fluid, scene.gravity);
  return all;
}

/// The largest distance of sums from assembled systems over some soils.
double distance_of_sums(const Scene& given, const Mesh& mesh, bool with_interface) {
  const ResolvedScene resolved = resolve(given, mesh);
  Scene scene = resolved.scene;
  const auto own = coefficients_of(scene, scene.regions);
  std::map<std::string, Varied> varied;
  for (const auto& [region, other] : coefficients_of(scene, other_soil(scene.regions, 1)))
    for (std::size_t q = 0; q < other.size(); ++q)
      if (other[q] != own.at(region)[q]) varied[region][q] = true;
  const AffineScene affine = affine_scene(scene, mesh, resolved.absent, varied, with_interface);
  EXPECT_GT(affine.parts.size(), 5U);
  double largest = 0.;
  for (const unsigned seed : {2U, 3U}) {
    Scene other = scene;
    other.regions = other_soil(scene.regions, seed);
    const AssembledScene assembled = assemble_scene(other, mesh, resolved.absent, {}, with_interface);
    const std::vector<double> factors = affine.factors(coefficients_of(scene, other.regions));
    largest = std::max(largest, distance(assembled.compiled->system, affine.at(factors).system));
    std::vector<double> without = factors;
    for (std::size_t q = 0; q < factors.size(); ++q) {
      without[q] = 0.;
      if (factors[q] != 0.) {
        EXPECT_GT(distance(affine.at(factors).system, affine.at(without).system), 1e-9) << q;
      }
      without[q] = factors[q];
    }
  }
  return largest;
}

Scene full(Scene scene) {
  scene.mesh.full_domain = true;
  return scene;
}

TEST(AffineScene, OfABreakwaterWithASea) {
  Scene scene = full(breakwater(triangle(1e6, 0.3)));
  add_sea(scene);
  const auto mesh = breakwater_mesh(0.4, with_sea());
  EXPECT_LT(distance_of_sums(scene, *mesh, false), 1e-10);
  EXPECT_LT(distance_of_sums(scene, *mesh, true), 1e-10);
}

TEST(AffineScene, OfInertialFlowAndSidesThatAbsorb) {
  Scene scene = full(breakwater(triangle(1e6, 0.3)));
  scene.regions["mound"].flow = Flow::inertial;
  scene.regions["seabed"].flow = Flow::inertial;
  for (const char* side : {"left", "right"}) {
    scene.boundaries[side].displacement = DisplacementCondition::absorbing;
    scene.boundaries[side].pressure = PressureCondition::absorbing;
  }
  scene.base_stress = true;
  const auto mesh = breakwater_mesh(0.4);
  EXPECT_LT(distance_of_sums(scene, *mesh, false), 1e-10);
  scene.regions["seabed"].flow = Flow::darcy;
  EXPECT_LT(distance_of_sums(scene, *mesh, false), 1e-10);
}

TEST(AffineScene, OfSoilThatDrainsAlongItsLayers) {
  Scene scene = full(breakwater(triangle(1e6, 0.3)));
  scene.regions["seabed"].conductivity_ratio = 0.2;
  scene.regions["mound"].conductivity_ratio = 3.;
  scene.regions["mound"].flow = Flow::inertial;
  const auto mesh = breakwater_mesh(0.4);
  EXPECT_LT(distance_of_sums(scene, *mesh, false), 1e-10);
}

TEST(AffineScene, OfDrainedSoilWithoutDampingAndAnElasticCaisson) {
  Scene scene = full(breakwater(triangle(1e6, 0.3)));
  scene.regions["seabed"].damping.reset();
  scene.regions["mound"].flow = Flow::drained;
  scene.probes["p"] = {{0., -3.}};
  const auto mesh = breakwater_mesh(0.4);
  EXPECT_LT(distance_of_sums(scene, *mesh, false), 1e-10);
}

}  // namespace affine_scene_test
}  // namespace upbead::test
