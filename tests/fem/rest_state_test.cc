// Claims: the tangent of soil with laws is the derivative of its nodal forces, and nodal forces of elastic cells are
// K x. At rest, soil that can bear its weights elastically is elastic; a breakwater's soil is within its strength and
// in equilibrium; a section that cannot stand is reported with its place.

#include "fem/rest_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "fem/ground.h"
#include "scenes.h"

namespace upbead::test {
namespace rest_state_test {

Scene failing_breakwater(double mound_angle, double cohesion) {
  Scene scene = breakwater(triangle(1., 0.1));
  scene.initial.emplace().water_level = 15.;
  scene.regions["seabed"].law = scene.regions["mound"].law = SoilLaw::mohr_coulomb;
  scene.regions["seabed"].strength = Strength{35.};
  scene.regions["mound"].strength = Strength{mound_angle, cohesion};
  return scene;
}

TEST(StaticSoil, ExertsKxWhereElasticAndHasItsTangentWhereItFails) {
  const auto mesh = breakwater_mesh(0.5);
  const Scene scene = at_rest(failing_breakwater(40., 5e3));
  const Ground ground(scene, *mesh, {});
  StaticSoil soil(ground.space(), ground.unknowns());
  std::srand(1);  // of Eigen's random numbers
  const Vector x = 1e-3 * Vector::Random(ground.unknowns().size()), d = Vector::Random(x.size());
  Vector force, more, less, values(soil.pattern().nonZeros());
  soil.exert(x, force);
  soil.tangent(values);
  SparseMatrix K = soil.pattern();
  std::copy_n(values.data(), values.size(), K.valuePtr());
  EXPECT_LT((K * x - force).norm(), 1e-12 * force.norm());
  EXPECT_LT((Vector(K.transpose() * d) - K * d).norm(), 1e-12 * (K * d).norm());

  StaticLaws laws(mesh->triangulation.n_active_cells());
  for (const Cell& cell : ground.space().dofs().active_cell_iterators())
    if (ground.space().has_matrices(cell))
      laws[cell->active_cell_index()] =
          std::make_shared<const MohrCoulombLaw>(ground.space().material(cell), MohrCoulombStrength{40., 5e3, 10., 0.});
  soil.follow(laws);
  const double h = 1e-9;
  soil.exert(x + h * d, more);
  soil.exert(x - h * d, less);
  soil.exert(x, force);
  soil.tangent(values);
  std::copy_n(values.data(), values.size(), K.valuePtr());
  const Vector slope = (more - less) / (2. * h);
  EXPECT_LT((K * d - slope).norm(), 2e-4 * slope.norm());  // of which 1e-5 of the elastic stiffness
  EXPECT_GT((Vector(K.transpose() * d) - K * d).norm(), 1e-2 * slope.norm()) << "psi' differs from phi'";
  EXPECT_LT(force.norm(), 0.5 * (soil.follow({StaticLaws(laws.size())}), soil.exert(x, more), more.norm()));
}

TEST(RestState, IsTheElasticOneWhereThatIsBorne) {
  Region layer = sand();
  layer.law = SoilLaw::mohr_coulomb;
  layer.strength = Strength{35.};
  Scene scene = column(layer, triangle(1., 1.));
  scene.initial.emplace().water_level = 30.;
  const auto mesh = column_mesh(10., 8);
  const RestState rest = rest_state(scene, *mesh, {});
  EXPECT_EQ(rest.share_at_strength, 0.);
  EXPECT_LE(rest.report.residual, 1e-6);
  const StaticStage elastic = solve_static(scene, *mesh);
  for (std::size_t cell = 0; cell < rest.stresses.size(); ++cell) {
    double mean = 0.;
    for (const PlaneStress& s : rest.stresses[cell]) mean -= s.yy / static_cast<double>(rest.stresses[cell].size());
    EXPECT_NEAR(mean, elastic.stress.vertical[cell], 1e-5 * elastic.stress.vertical[0]);
  }
  scene.initial->k0 = 0.8;
  for (const auto& of_cell : rest_state(scene, *mesh, {}).stresses)
    for (const PlaneStress& s : of_cell) EXPECT_NEAR(s.xx, 0.8 * s.yy, 1e-5 * elastic.stress.vertical[0]);
}

TEST(RestState, OfABreakwaterIsWithinItsStrength) {
  const auto mesh = breakwater_mesh(0.25);
  for (const bool with_k0 : {false, true}) {
    Scene scene = failing_breakwater(40., 0.);
    if (with_k0) scene.initial->k0 = 0.45;
    const RestState rest = rest_state(scene, *mesh, {});
    ASSERT_TRUE(rest.found);
    EXPECT_LE(rest.report.residual, 1e-6);
    EXPECT_GT(rest.share_at_strength, 0.01);
    EXPECT_LT(rest.share_at_strength, 0.7);
    double worst = -1e300, size = 0.;
    for (const auto& cell : mesh->triangulation.active_cell_iterators()) {
      const Region& region = scene.regions.at(mesh->surface_of(cell));
      if (region.law == SoilLaw::elastic) continue;
      const MohrCoulombLaw law(elastic_law(*region.shear_modulus, *region.poissons_ratio),
                               {region.strength->friction_angle, 0., 0., 0.});
      for (const PlaneStress& s : rest.stresses[cell->active_cell_index()]) {
        worst = std::max(worst, law.excess(s));
        size = std::max(size, std::abs(s.yy));
      }
    }
    EXPECT_LE(worst, 1e-9 * size);
  }
}

TEST(RestState, TellsWhatCannotStand) {
  const auto mesh = breakwater_mesh(0.25);
  const RestState rest = rest_state(failing_breakwater(20., 0.), *mesh, {});  // slopes steeper than phi'
  EXPECT_FALSE(rest.found);
  EXPECT_LT(rest.report.reached, 1.);
  EXPECT_EQ(rest.gives_way.rfind("region 'mound' at ", 0), 0u) << rest.gives_way;
}

}  // namespace rest_state_test
}  // namespace upbead::test
