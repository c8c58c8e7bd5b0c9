// Claims, on two different scenes whose soil yields: a mirrored mesh gives the mirrored result, other units and a
// similar model give the same result, both routes to F_T agree, and the balance of energy closes with the energy
// taken by the soil.
#include <deal.II/grid/grid_tools.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mirror.h"
#include "yielding_march.h"

namespace upbead::test {
namespace symmetry_test {

struct Given {
  const char* name;
  SoilLaw law;
  bool wet;
  double force, duration, end;
};

/// Saturated and damped by Rayleigh's factors, hysteretic; and dry, without any damping, Mohr-Coulomb.
const Given scenes[] = {{"hysteretic, saturated", SoilLaw::hysteretic, true, 3e6, 0.15, 0.45},
                        {"Mohr-Coulomb, drained, undamped", SoilLaw::mohr_coulomb, false, 2e6, 0.3, 0.6}};

Scene scene_of(const Given& given) {
  Scene scene = breakwater(triangle(given.force, given.duration));
  give_law(scene, given.law, 38., 20e3);
  for (const char* soil : {"seabed", "mound"})
    if (!given.wet) {
      scene.regions[soil].flow = Flow::drained;
      scene.regions[soil].damping.reset();
    }
  scene.probes["sand"].at = {4., -3.};
  return scene;
}

double difference(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
  return a.size() == b.size() && b.cwiseAbs().maxCoeff() > 0. ? (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff()
                                                              : 1.;
}

/// Factors of lengths, times and densities, from which all other factors follow.
struct Factors {
  double length, time, density;
  double stress() const { return density * length * length / (time * time); }
};

void scale(std::optional<double>& value, double factor) {
  if (value) *value *= factor;
}

Scene similar(Scene scene, const Given& given, const Factors& by) {
  scene.time.end *= by.time;
  scene.gravity *= by.length / (by.time * by.time);
  scene.fluid.density *= by.density;
  scene.fluid.bulk_modulus *= by.stress();
  *scene.initial->water_level *= by.length;
  for (auto& [name, region] : scene.regions) {
    scale(region.shear_modulus, by.stress());
    scale(region.density, by.density);
    scale(region.grain_density, by.density);
    scale(region.hydraulic_conductivity, by.length / by.time);
    if (region.strength) region.strength->cohesion *= by.stress();
    if (region.damping)
      for (double& frequency : region.damping->frequencies) frequency /= by.time;
  }
  for (auto& [name, probe] : scene.probes)
    for (double& x : probe.at) x *= by.length;
  scene.loads["impulse"].history = triangle(by.stress() * by.length * given.force, by.time * given.duration);
  return scene;
}

class YieldingScenes : public ::testing::TestWithParam<int> {
 protected:
  const Given given = scenes[GetParam()];
  const Scene scene = scene_of(given);
  const double step = given.end / 48.;
  const std::string what = std::string(given.name) + ": ";
};

TEST_P(YieldingScenes, BothRoutesAgreeAndEnergyCloses) {
  const auto mesh = breakwater_mesh(0.5);
  const YieldingMarch found(scene, *mesh, given.end, step);
  Record record("yielding_identities");
  record.at_most(what + "both routes to F_T, over its largest", found.routes(), 1e-6);
  record.at_most(what + "energy, work minus all energies stored and taken, over the largest work",
                 found.energy().mismatch(), 1e-8);
  record.at_most(what + "energy taken by the scheme, over the largest work",
                 std::abs(found.energy().scheme) / found.energy().largest_work, 0.01);
  record.at_least(what + "energy taken by the soil, over the largest work",
                  found.energy().plastic / found.energy().largest_work, 0.01);
}

class SimilarScenes : public YieldingScenes {};

TEST_P(SimilarScenes, MirroredMeshGivesMirroredAnswer) {
  const auto mesh = breakwater_mesh(0.5), mirrored = breakwater_mesh(0.5);
  mirror(*mirrored);
  Scene other = scene;
  other.loads["impulse"].direction = {-1., 0.};
  other.probes["sand"].at = {-4., -3.};
  const YieldingMarch left(scene, *mesh, given.end, step), right(other, *mirrored, given.end, step);
  Record record("yielding_identities");
  for (const char* odd : {"shear_force", "caisson/displacement_x", "probes/sand/effective_stress_xy"})
    record.at_most(what + "mirrored: " + odd, difference(left.history(odd), -right.history(odd)), 1e-5);
  for (const char* even : {"caisson/displacement_y", "probes/sand/effective_stress_xx"})
    record.at_most(what + "mirrored: " + even, difference(left.history(even), right.history(even)), 1e-5);
}

/// Millimetres, tonnes and milliseconds; and a model at 1:20 by Froude's law, in the same gravity and water.
TEST_P(SimilarScenes, OtherUnitsAndSizesGiveTheSameAnswer) {
  const auto mesh = breakwater_mesh(0.5);
  const YieldingMarch whole(scene, *mesh, given.end, step);
  Record record("yielding_identities");
  for (const auto& [kind, by] : {std::pair{"in mm, t and ms: ", Factors{1e3, 1e3, 1e-12}},
                                 {"at 1:20 by Froude: ", Factors{1. / 20., 1. / std::sqrt(20.), 1.}}}) {
    const auto other_mesh = breakwater_mesh(0.5);
    dealii::GridTools::scale(by.length, other_mesh->triangulation);
    const YieldingMarch other(similar(scene, given, by), *other_mesh, by.time * given.end, by.time * step);
    const std::pair<const char*, double> readings[] = {{"shear_force", by.stress() * by.length},
                                                       {"caisson/displacement_x", by.length},
                                                       {"caisson/rotation", 1.},
                                                       {"probes/sand/effective_stress_yy", by.stress()}};
    for (const auto& [reading, factor] : readings)
      record.at_most(what + kind + reading, difference(other.history(reading) / factor, whole.history(reading)), 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, YieldingScenes, ::testing::Values(0, 1));
INSTANTIATE_TEST_SUITE_P(One, SimilarScenes, ::testing::Values(0));
INSTANTIATE_TEST_SUITE_P(OtherAtLength, SimilarScenes, ::testing::Values(1));

}  // namespace symmetry_test
}  // namespace upbead::test
