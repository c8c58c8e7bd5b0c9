// Claims: with every kind of region and of side at once M, C and K are symmetric, and in a march by either scheme the
// balance of energy closes and both routes to F_T agree.
// Source: docs/theory.md. Limits: 1e-13 of each matrix's largest entry; 1e-8 for the identities.

#include <gtest/gtest.h>

#include <cmath>

#include "record.h"
#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace every_kind_test {

constexpr double left = -40., right = 40., base = -12., level = 14., top = 20.;

/// A caisson on a mound, rubble with inertia in front and drained behind, on gravel over sand; an elastic block behind
/// it; a sea on either side.
std::string surface(const dealii::Point<dim>& at) {
  const double x = at[0], y = at[1];
  if (y < -4.) return "sand";
  if (y < 0.) return "gravel";
  if (std::abs(x) < 14. && y < 4.) return x < 0. ? "mound" : "drained_mound";
  if (std::abs(x) < 8.) return "caisson";
  if (x > 18. && x < 24. && y < 6.) return "block";
  return y > level ? "" : x < 0. ? "sea_front" : "sea_back";
}

std::string curve(const dealii::Point<dim>& at) {
  const double x = at[0], y = at[1], tiny = 1e-9;
  const bool side = x < left + tiny || x > right - tiny;
  if (side) return y > 0. ? "sea_end" : y > -4. ? "gravel_side" : "sand_side";
  if (y < base + tiny) return "base";
  if (std::abs(x) < 8. + tiny && y > level) return "dry_caisson";
  return y > level - tiny && std::abs(x) > 8. ? "sea_surface" : "";
}

std::unique_ptr<Mesh> mesh_of_everything() {
  const std::vector<double> x{left, -32., -26., -20., -14., -11., -8., -5., 0.,
                              5.,   8.,   11.,  14.,  18.,  21.,  24., 32., right};
  return tensor_mesh(x, {base, -8., -4., -2., 0., 2., 4., 6., 10., level, top}, surface, curve);
}

Region elastic_block() {
  Region block;
  block.kind = RegionKind::solid;
  block.deformation = Deformation::elastic;
  block.youngs_modulus = 30e9;
  block.poissons_ratio = 0.2;
  block.density = 2400.;
  return block;
}

Scene everything(Compressibility compressibility) {
  Scene scene = breakwater(triangle(1., 0.1));
  scene.loads.clear();
  scene.boundaries.clear();
  scene.regions = {{"sand", sand()},           {"gravel", rubble()}, {"mound", rubble()}, {"drained_mound", rubble()},
                   {"block", elastic_block()}, {"sea_front", {}},    {"sea_back", {}},    {"caisson", {}}};
  scene.regions["sand"].flow = Flow::darcy;
  scene.regions["gravel"].flow = scene.regions["mound"].flow = Flow::inertial;
  scene.regions["drained_mound"].flow = Flow::drained;
  scene.regions["caisson"].kind = RegionKind::rigid;
  scene.regions["caisson"].density = 2100.;
  for (const char* sea : {"sea_front", "sea_back"}) {
    scene.regions[sea].kind = RegionKind::water;
    scene.regions[sea].compressibility = compressibility;
  }
  scene.boundaries["base"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  scene.boundaries["sand_side"] = {DisplacementCondition::absorbing, PressureCondition::sealed};
  scene.boundaries["gravel_side"] = {DisplacementCondition::absorbing, PressureCondition::absorbing};
  scene.boundaries["sea_end"].pressure = PressureCondition::absorbing;
  scene.boundaries["sea_surface"].pressure = PressureCondition::surface_waves;
  scene.boundaries["dry_caisson"] = {};
  Load load;
  load.region = "caisson";
  load.at = {-8., 12.};
  load.history = triangle(1.6e6, 0.15);
  scene.loads["impulse"] = load;
  return scene;
}

double asymmetry(const SparseMatrix& matrix) {
  const SparseMatrix difference = matrix - SparseMatrix(matrix.transpose());
  return difference.coeffs().cwiseAbs().maxCoeff() / matrix.coeffs().cwiseAbs().maxCoeff();
}

/// Largest |a_ij - a_ji| over sqrt(s_i s_j), s the row's largest entry: small entries count as much as large ones.
double scaled_asymmetry(const SparseMatrix& matrix) {
  Vector scale = Vector::Zero(matrix.rows());
  for (int i = 0; i < matrix.outerSize(); ++i)
    for (SparseMatrix::InnerIterator entry(matrix, i); entry; ++entry)
      scale[i] = std::max(scale[i], std::abs(entry.value()));
  double worst = 0.;
  const SparseMatrix difference = matrix - SparseMatrix(matrix.transpose());
  for (int i = 0; i < difference.outerSize(); ++i)
    for (SparseMatrix::InnerIterator entry(difference, i); entry; ++entry)
      if (entry.value() != 0.)
        worst = std::max(worst, std::abs(entry.value()) / std::sqrt(scale[entry.row()] * scale[entry.col()]));
  return worst;
}

TEST(EveryKind, MatricesAreSymmetric) {
  Record record("water_identities");
  const auto mesh = mesh_of_everything();
  for (const int degree : {2, 3}) {
    Scene scene = everything(Compressibility::compressible);
    scene.mesh.degree = degree;
    const Compiled compiled(scene, *mesh);
    const System& system = compiled.system;
    for (const auto& [name, matrix] : {std::pair{"M", &system.M}, {"C", &system.C}, {"K", &system.K}}) {
      const std::string title = "degree " + std::to_string(degree) + ", " + name;
      record.at_most(title + ": largest abs(a_ij - a_ji) over the largest entry", asymmetry(*matrix), 1e-13);
      record.at_most(title + ": largest abs(a_ij - a_ji) over sqrt(s_i s_j), s_i the largest entry of row i",
                     scaled_asymmetry(*matrix), 1e-12);
    }
  }
}

class EveryKind : public ::testing::TestWithParam<std::tuple<SchemeKind, Compressibility>> {};

TEST_P(EveryKind, BothRoutesToShearForceAndTheEnergyBalance) {
  const auto [scheme, compressibility] = GetParam();
  Record record("water_identities");
  const auto mesh = mesh_of_everything();
  const Compiled compiled(everything(compressibility), *mesh);
  const Response response = run(compiled, 0.6, 0.01, scheme);
  const ShearResponse shear = shear_of(compiled, response);
  const EnergyAccount& energy = response.energy.back();
  const std::string title = std::string(scheme == SchemeKind::sdirk4 ? "SDIRK4, " : "generalised-alpha, ") +
                            (compressibility == Compressibility::compressible ? "" : "in") + "compressible water";
  record.at_most(title + ": difference between the two routes to F_T", shear.reaction_mismatch, 1e-8);
  record.at_most(title + ": energy that is not accounted for", energy.mismatch(), 1e-8);
  record.at_least(title + ": energy that leaves through absorbing sides, over the work",
                  energy.radiated / energy.largest_work, 1e-3);
  EXPECT_GT(shear.peak_shear, 0.1e6);
}

INSTANTIATE_TEST_SUITE_P(SchemesAndWaters, EveryKind,
                         ::testing::Combine(::testing::Values(SchemeKind::sdirk4, SchemeKind::generalised_alpha),
                                            ::testing::Values(Compressibility::compressible,
                                                              Compressibility::incompressible)));

}  // namespace every_kind_test
}  // namespace upbead::test
