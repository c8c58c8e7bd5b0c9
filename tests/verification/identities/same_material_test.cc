// Claims: limit cases of one kind of region are another. If the water cannot move, porous soil is an undrained solid,
// and inertial flow is darcy flow. If the water has no pressure, drained soil is a solid of the same density. A solid
// caisson a million times as stiff as its ground is a rigid one. Source: the equations; lambda_u = lambda + alpha^2
// Q. Limits, of the largest value of F_T: stated beside each with its reason.

#include <gtest/gtest.h>

#include "record.h"
#include "scenes.h"

namespace upbead::test {
namespace same_material_test {

Eigen::RowVectorXd shear_force(const Scene& scene, const Mesh& mesh) {
  const Compiled compiled(scene, mesh);
  return history(compiled, run(compiled, 0.4, 0.0125), "shear_force");
}

double largest_difference(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

/// A solid with the stiffness and density of a porous region whose water cannot move (or has no pressure).
Region solid_like(const Region& porous, const Fluid& fluid, bool undrained) {
  const Material m = material(porous, fluid, 9.81);
  const double lambda = m.lambda + (undrained ? m.alpha * m.alpha / m.storage : 0.);
  Region solid;
  solid.kind = RegionKind::solid;
  solid.shear_modulus = m.G;
  solid.poissons_ratio = 0.5 * lambda / (lambda + m.G);
  solid.density = m.rho;
  solid.damping = porous.damping;
  return solid;
}

TEST(SameMaterial, WaterThatCannotMoveMakesFlowsAlike) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  scene.regions["mound"].hydraulic_conductivity = 1e-4;
  const auto mesh = breakwater_mesh(0.5);
  scene.regions["mound"].flow = Flow::darcy;
  const auto darcy = shear_force(scene, *mesh);
  scene.regions["mound"].flow = Flow::inertial;
  // The neglected term is of order X = k omega/(g n), 5e-4 at omega = pi/0.15 s.
  Record("identities")
      .at_most("inertial against darcy flow in a mound of X below 1e-3: F_T",
               largest_difference(darcy, shear_force(scene, *mesh)), 1e-3);
}

TEST(SameMaterial, SoilThatLetsNoWaterThroughIsAnUndrainedSolid) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  // with some air; otherwise the solid is nearly incompressible and its elements lock
  scene.fluid.bulk_modulus = 50e6;
  for (const char* name : {"seabed", "mound"}) {
    scene.regions[name].hydraulic_conductivity = 1e-12;
    scene.regions[name].flow = Flow::darcy;
    // stiffness-proportional damping would not include the water's share of the stiffness
    scene.regions[name].damping.reset();
  }
  const auto mesh = breakwater_mesh(1.);
  const auto porous = shear_force(scene, *mesh);
  for (const char* name : {"seabed", "mound"}) scene.regions[name] = solid_like(scene.regions[name], scene.fluid, true);
  // The pressure has one degree less than the displacements: the difference is an error of the mesh, not of the
  // model.
  Record("identities")
      .at_most("porous ground of k = 1e-12 m/s against an undrained solid: F_T",
               largest_difference(porous, shear_force(scene, *mesh)), 5e-3);
}

TEST(SameMaterial, DrainedSoilIsASolid) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  for (const char* name : {"seabed", "mound"}) scene.regions[name].flow = Flow::drained;
  const auto mesh = breakwater_mesh(0.5);
  const auto drained = shear_force(scene, *mesh);
  for (const char* name : {"seabed", "mound"})
    scene.regions[name] = solid_like(scene.regions[name], scene.fluid, false);
  Record("identities")
      .at_most("drained ground against a solid: F_T", largest_difference(drained, shear_force(scene, *mesh)), 1e-11);
}

TEST(SameMaterial, StiffSolidCaissonIsRigid) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  const auto mesh = breakwater_mesh(0.5);
  const Compiled rigid(scene, *mesh);
  Region& caisson = scene.regions["caisson"];
  caisson.kind = RegionKind::solid;
  caisson.deformation = Deformation::elastic;
  caisson.shear_modulus = 1e6 * *scene.regions["mound"].shear_modulus;
  caisson.poissons_ratio = 0.2;
  const Compiled solid(scene, *mesh);
  const Response a = run(rigid, 0.4, 0.0125), b = run(solid, 0.4, 0.0125);
  Record record("identities");
  // Deformation is of order 1e-6 of the motion, and a few times that where the load acts.
  for (const char* reading : {"shear_force", "caisson/displacement_x", "caisson/rotation", "base_moment"})
    record.at_most(std::string("solid caisson of 1e6 times the mound's stiffness against a rigid one: ") + reading,
                   largest_difference(history(rigid, a, reading), history(solid, b, reading)), 1e-5);
}

}  // namespace same_material_test
}  // namespace upbead::test
