// Claims: a thick ring under inner pressure has the exact yield radius and displacements, and bursts at the exact
// pressure.

#include <gtest/gtest.h>

#include <deal.II/grid/grid_tools.h>
#include <cmath>

#include "fem/static_march.h"
#include "record.h"
#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace ring_test {

constexpr double a = 1., b = 2., G = 1e7, nu = 0.3, k = 1e4;  // k: strength in shear

/// Hill (1950), ch. V: plane strain, sigma_z between the other two; c is the radius of the yielded part.
double pressure(double c) {
  return 2. * k * std::log(c / a) + k * (1. - c * c / (b * b));
}
double outer_displacement(double c) {
  return (1. - nu) * k * c * c / (G * b);
}
double inner_displacement(double c) {
  return (-(1. - 2. * nu) * a * pressure(c) + 2. * (1. - nu) * k * c * c / a) / (2. * G);
}

std::unique_ptr<Mesh> quarter_ring(int radial, int around) {
  const double right = std::acos(0.);
  auto mesh = tensor_mesh(
      even_lines(a, b, radial), even_lines(0., right, around), [](const dealii::Point<dim>&) { return "soil"; },
      [&](const dealii::Point<dim>& p) -> std::string {
        if (p[0] < a + 1e-9) return "inner";
        if (p[0] > b - 1e-9) return "outer";
        return p[1] < 1e-9 ? "x_axis" : p[1] > right - 1e-9 ? "y_axis" : "";
      });
  dealii::GridTools::transform(
      [](const dealii::Point<dim>& p) { return dealii::Point<dim>(p[0] * std::cos(p[1]), p[0] * std::sin(p[1])); },
      mesh->triangulation);
  return mesh;
}

Scene ring_scene() {
  Scene scene;
  Region& soil = scene.regions["soil"];
  soil.kind = RegionKind::solid;
  soil.deformation = Deformation::elastic;
  soil.density = 1.;
  soil.shear_modulus = G;
  soil.poissons_ratio = nu;
  scene.boundaries["inner"] = scene.boundaries["outer"] = {};
  scene.boundaries["x_axis"].displacement = DisplacementCondition::roller;
  scene.boundaries["y_axis"].displacement = DisplacementCondition::roller;
  Load& load = scene.loads["pressure"];
  load.boundary = "inner";
  load.kind = LoadKind::pressure;
  load.history = triangle(1., 1.);
  scene.probes["inner"].at = {a, 0.};
  scene.probes["outer"].at = {b, 0.};
  return scene;
}

class Ring {
 public:
  Ring(int radial, int around)
      : mesh_(quarter_ring(radial, around)),
        compiled_(ring_scene(), *mesh_),
        soil_(compiled_.space, compiled_.unknowns),
        x_(Vector::Zero(compiled_.unknowns.size())) {
    const auto law = std::make_shared<const MohrCoulombLaw>(elastic_law(G, nu), MohrCoulombStrength{0., k, 0., 1e12});
    soil_.follow(StaticLaws(mesh_->triangulation.n_active_cells(), law));
  }
  StaticReport push(double from, double to, double least) {
    StaticPath path;
    path.load = [&](double p) -> Vector { return p * compiled_.system.loads[0].vector; };
    StaticSteps steps;
    steps.from = from;
    steps.to = to;
    steps.first = steps.largest = 0.25 * (to - from);
    steps.least = least;
    steps.tolerance = 1e-9;
    return march_static(soil_, path, steps, x_);
  }
  double displacement(const std::string& probe) const {
    const System& system = compiled_.system;
    double sum = 0.;
    for (const auto& [i, weight] :
         system.readings[static_cast<std::size_t>(system.reading("probes/" + probe + "/displacement_x"))].position)
      sum += weight * x_[i];
    return sum;
  }

 private:
  std::unique_ptr<Mesh> mesh_;
  Compiled compiled_;
  StaticSoil soil_;
  Vector x_;
};

TEST(Ring, YieldsAndBurstsAsHillFoundAtLength) {
  Record record("ring");
  Ring ring(24, 24);
  double before = 0.;
  for (const double c : {1., 1.25, 1.5, 1.75}) {
    const StaticReport report = ring.push(before, pressure(c), 1.);
    ASSERT_TRUE(report.complete);
    before = pressure(c);
    const std::string at = ", yielded to " + std::to_string(c).substr(0, 4) + " a";
    record.at_most("displacement inside" + at, std::abs(ring.displacement("inner") / inner_displacement(c) - 1.), 2e-3);
    record.at_most("displacement outside" + at, std::abs(ring.displacement("outer") / outer_displacement(c) - 1.),
                   2e-3);
  }
  const double burst = 2. * k * std::log(b / a);
  const StaticReport report = ring.push(before, 1.2 * burst, 5e-4 * burst);
  ASSERT_FALSE(report.complete);
  record.at_most("pressure at which it bursts, from below", std::abs(report.reached / burst - 1.), 3e-3);
  record.at_most("from above", std::abs(report.failed / burst - 1.), 3e-3);
}

}  // namespace ring_test
}  // namespace upbead::test
