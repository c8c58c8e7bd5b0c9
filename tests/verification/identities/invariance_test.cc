// Claims: mirrored meshes give mirrored results; scaled units give scaled results; loads superpose. Source:
// symmetries of the equations. Tolerance: 1e-10 of the largest value, round-off of some hundred solves; 1e-11 for
// superposition.

#include <deal.II/grid/grid_tools.h>
#include <gtest/gtest.h>

#include "mirror.h"
#include "record.h"
#include "scenes.h"

namespace upbead::test {
namespace invariance_test {

constexpr double tolerance = 1e-10;

void expect_equal(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance * a.cwiseAbs().maxCoeff());
  EXPECT_GT(a.cwiseAbs().maxCoeff(), 0.);
}

class Schemes : public ::testing::TestWithParam<SchemeKind> {};

TEST_P(Schemes, MirroredMeshGivesMirroredAnswer) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  scene.probes["sand"].at = {4., -3.};
  const auto mesh = breakwater_mesh(0.5);
  const Compiled left(scene, *mesh);
  const Response from_left = run(left, 0.5, 0.0125, GetParam());

  const auto mirrored = breakwater_mesh(0.5);
  mirror(*mirrored);
  scene.loads["impulse"].direction = {-1., 0.};
  scene.probes["sand"].at = {-4., -3.};
  const Compiled right(scene, *mirrored);
  const Response from_right = run(right, 0.5, 0.0125, GetParam());

  for (const char* odd : {"shear_force", "caisson/displacement_x", "caisson/rotation", "base_moment",
                          "probes/sand/displacement_x", "probes/sand/effective_stress_xy"})
    expect_equal(history(left, from_left, odd), -history(right, from_right, odd));
  for (const char* even : {"probes/sand/displacement_y", "probes/sand/pressure", "probes/sand/effective_stress_xx"})
    expect_equal(history(left, from_left, even), history(right, from_right, even));
}

/// The scene in millimetres, tonnes and milliseconds: stress and density x 1e-12, force per length x 1e-9.
Scene in_mm_t_ms(Scene scene) {
  const auto scale = [](std::optional<double>& value, double factor) {
    if (value) *value *= factor;
  };
  scene.time.end *= 1e3;
  scene.gravity *= 1e-3;
  scene.fluid.density *= 1e-12;
  scene.fluid.bulk_modulus *= 1e-12;
  for (auto& entry : scene.regions) {
    Region& region = entry.second;
    scale(region.shear_modulus, 1e-12);
    scale(region.density, 1e-12);
    scale(region.grain_density, 1e-12);
    if (region.damping) region.damping->frequencies = {1e-3, 10e-3};
  }
  for (auto& probe : scene.probes)
    for (double& x : probe.second.at) x *= 1e3;
  return scene;
}

TEST_P(Schemes, ScaledUnitsGiveScaledAnswers) {
  Scene si = breakwater(triangle(1e6, 0.15));
  si.probes["mound"].at = {2., 4.};
  Scene scaled = in_mm_t_ms(si);
  scaled.loads["impulse"].history = triangle(1e-3, 150.);
  const auto mesh = breakwater_mesh(0.5), mesh_mm = breakwater_mesh(0.5);
  dealii::GridTools::scale(1e3, mesh_mm->triangulation);
  const Compiled a(si, *mesh), b(scaled, *mesh_mm);
  const Response in_si = run(a, 0.5, 0.0125, GetParam()), in_mm = run(b, 500., 12.5, GetParam());
  expect_equal(history(a, in_si, "shear_force"), 1e9 * history(b, in_mm, "shear_force"));
  expect_equal(history(a, in_si, "caisson/displacement_x"), 1e-3 * history(b, in_mm, "caisson/displacement_x"));
  expect_equal(history(a, in_si, "caisson/rotation"), history(b, in_mm, "caisson/rotation"));
  expect_equal(history(a, in_si, "probes/mound/pressure"), 1e12 * history(b, in_mm, "probes/mound/pressure"));
}

TEST_P(Schemes, LoadsSuperpose) {
  const auto mesh = breakwater_mesh(0.5);
  Scene first = breakwater(triangle(1e6, 0.15));
  first.probes["sand"].at = {4., -3.};
  Scene second = first, both = first;
  second.loads["impulse"].history = triangle(-2e5, 0.4, 0.075);
  both.loads["second"] = second.loads["impulse"];
  const Compiled a(first, *mesh), b(second, *mesh), c(both, *mesh);
  const Response of_a = run(a, 0.5, 0.0125, GetParam()), of_b = run(b, 0.5, 0.0125, GetParam()),
                 of_both = run(c, 0.5, 0.0125, GetParam());
  Record record("identities");
  const auto check = [&](const std::string& reading, double limit) {
    const Eigen::RowVectorXd sum = history(a, of_a, reading) + history(b, of_b, reading);
    const double difference = (history(c, of_both, reading) - sum).cwiseAbs().maxCoeff() / sum.cwiseAbs().maxCoeff();
    const char* scheme = GetParam() == SchemeKind::sdirk4 ? "sdirk4" : "generalised_alpha";
    record.at_most(std::string("superposition of two forces, ") + scheme + ": " + reading, difference, limit);
  };
  check("shear_force", 1e-11);
  check("caisson/displacement_x", 1e-11);
  check("probes/sand/pressure", 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Both, Schemes, ::testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha));

}  // namespace invariance_test
}  // namespace upbead::test
