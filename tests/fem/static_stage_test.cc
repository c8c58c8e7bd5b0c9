// Claim: the stresses of the static state are those of closed forms within 0.5 %, and the stiffness follows from
// these stresses.
// Sources: a layer under its weight, s'_y = gamma' z, s'_x = nu/(1 - nu) s'_y; a uniform strip q of width 2b on a
// half-plane, s_x + s_y = (2q/pi) alpha, alpha the angle that it subtends (Flamant; Poulos and Davis 1974,
// section 3.1).

#include "fem/static_stage.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "scenes.h"
#include "tensor_mesh.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace static_stage_test {

constexpr double pi = boost::math::constants::pi<double>();
constexpr double nu = 0.33, unit_weight = 0.6 * (2650. - 1030.) * 9.81;

Region soil_by_stress(const StressLaw& law) {
  Region region = sand();
  region.poissons_ratio = nu;
  region.shear_modulus.reset();
  region.stress_law = law;
  return region;
}

double centre_y(const dealii::Triangulation<dim>::active_cell_iterator& cell) {
  return cell->center()[1];
}

class Layer : public testing::Test {
 protected:
  Layer() : scene_(column(soil_by_stress({60e6, 98e3, 0.5, 1e-3}), TimeFunction())) {
    scene_.initial = InitialState{100., {}};
  }
  Scene scene_;
  const std::unique_ptr<Mesh> mesh_ = column_mesh(10., 20);
};

TEST_F(Layer, UnderItsWeightHasTheClosedForm) {
  const StaticStage stage = solve_static(scene_, *mesh_);
  for (const auto& cell : mesh_->triangulation.active_cell_iterators()) {
    const std::size_t i = cell->active_cell_index();
    const double vertical = unit_weight * (10. - centre_y(cell)), horizontal = nu / (1. - nu) * vertical;
    EXPECT_NEAR(stage.stress.vertical[i], vertical, 1e-6 * vertical);
    EXPECT_NEAR(stage.stress.horizontal[i], horizontal, 1e-6 * vertical);
    EXPECT_NEAR(stage.stress.out_of_plane[i], horizontal, 1e-6 * vertical);
    const double mean = (vertical + 2. * horizontal) / 3.;
    EXPECT_NEAR(stage.shear_modulus[i], 60e6 * std::sqrt(mean / 98e3), 1e-5 * 60e6);
  }
}

TEST_F(Layer, AboveWaterWeighsMore) {
  scene_.initial->water_level = 4.;
  const StaticStage stage = solve_static(scene_, *mesh_);
  const double dry = 0.6 * 2650. * 9.81;
  for (const auto& cell : mesh_->triangulation.active_cell_iterators()) {
    const double z = 10. - centre_y(cell), above = std::min(z, 6.);
    const double vertical = dry * above + unit_weight * (z - above);
    EXPECT_NEAR(stage.stress.vertical[cell->active_cell_index()], vertical, 1e-3 * vertical) << z;
  }
}

TEST_F(Layer, TakesAGivenK0) {
  scene_.initial->k0 = 0.8;
  const StaticStage stage = solve_static(scene_, *mesh_);
  for (const auto& cell : mesh_->triangulation.active_cell_iterators()) {
    const double mean = (1. + 1.6) / 3. * unit_weight * (10. - centre_y(cell));
    EXPECT_NEAR(stage.shear_modulus[cell->active_cell_index()], 60e6 * std::sqrt(mean / 98e3), 1e-5 * 60e6);
  }
}

TEST_F(Layer, HasAFloorNearItsSurface) {
  scene_.regions["soil"].stress_law->floor = 30e3;
  double least = 1e300;
  for (const double G : solve_static(scene_, *mesh_).shear_modulus) least = std::min(least, G);
  EXPECT_NEAR(least, 60e6 * std::sqrt(30. / 98.), 1.);
  scene_.regions["soil"].stress_law->floor.reset();
  for (const double G : solve_static(scene_, *mesh_).shear_modulus) least = std::min(least, G);
  const double mean = (1. + 2. * nu / (1. - nu)) / 3. * unit_weight * 5.;
  EXPECT_NEAR(least, 60e6 * std::sqrt(0.1 * mean / 98e3), 1e-4 * 60e6) << "a tenth of the mean";
}

TEST_F(Layer, CarriesASurchargeWhole) {
  const StaticStage bare = solve_static(scene_, *mesh_);
  scene_.initial->surcharge["blocks"] = {"top", 30e3, {}, {}};
  const StaticStage loaded = solve_static(scene_, *mesh_);
  for (std::size_t i = 0; i < bare.stress.vertical.size(); ++i)
    EXPECT_NEAR(loaded.stress.vertical[i] - bare.stress.vertical[i], 30e3, 1e-9 * 30e3);
}

TEST_F(Layer, SettlesWithinFewSolves) {
  EXPECT_LE(solve_static(scene_, *mesh_).iterations, 3);
}

/// A soft, thin strip of weight q per area on wide and deep ground.
class Strip : public testing::Test {
 protected:
  static constexpr double b = 1., q = 100e3, thickness = 0.05;

  static std::unique_ptr<Mesh> mesh() {
    const std::vector<double> right = joined(even_lines(0., b, 12), graded_lines(b, 600. * b, b / 12., 1.15, 80. * b));
    std::vector<double> x = right;
    for (const double value : right) x.push_back(-value);
    const std::vector<double> depth = graded_lines(0., -600. * b, b / 12., 1.12, 80. * b);
    return tensor_mesh(
        joined(x, {}), joined(depth, {0., thickness}),
        [](const dealii::Point<dim>& p) {
          if (p[1] < 0.) return std::string("soil");
          return std::string(std::abs(p[0]) < b ? "strip" : "");
        },
        [](const dealii::Point<dim>& p) {
          if (std::abs(p[0]) > 599. * b) return std::string("sides");
          return std::string(p[1] < -599. * b ? "base" : p[1] > -1e-6 ? "top" : "");
        });
  }

  static Scene scene(double density) {
    Scene scene;
    scene.regions["soil"] = soil_by_stress({60e6, 98e3, 0., 1.});
    Region& strip = scene.regions["strip"];
    strip.kind = RegionKind::solid;
    strip.density = density;
    strip.shear_modulus = 60.;
    strip.poissons_ratio = 0.;
    scene.boundaries["base"] = {DisplacementCondition::fixed, PressureCondition::sealed};
    scene.boundaries["sides"] = {DisplacementCondition::absorbing, PressureCondition::sealed};
    scene.boundaries["top"] = {DisplacementCondition::free, PressureCondition::open};
    scene.initial = InitialState{-1000., {}};
    return scene;
  }
};

/// A surcharge has the stresses of a soft strip of that weight; its ends lie within faces.
TEST_F(Strip, ASurchargeHasTheStressesOfFlamant) {
  const std::unique_ptr<Mesh> ground = mesh();
  Scene loaded_scene = scene(1e-3);
  const double from = -0.87 * b, to = 0.61 * b;
  loaded_scene.initial->surcharge["armour"] = {"top", q, from, to};
  const StaticStage loaded = solve_static(loaded_scene, *ground), bare = solve_static(scene(1e-3), *ground);
  for (const auto& cell : ground->triangulation.active_cell_iterators()) {
    const double x = cell->center()[0], z = -cell->center()[1];
    if (z < 0.3 * b || z > 4. * b || std::abs(x) > 2. * b) continue;
    const std::size_t i = cell->active_cell_index();
    const double mean = (1. + nu) / 3. * 2. * q / pi * (std::atan((x - from) / z) - std::atan((x - to) / z));
    EXPECT_NEAR(loaded.stress.mean(i, {}) - bare.stress.mean(i, {}), mean, 5e-3 * q) << x << " " << z;
  }
}

/// Equilibrium: on any level, the vertical stress balances the load above.
TEST_F(Layer, CarriesAPartialSurchargeInSum) {
  std::vector<double> x = even_lines(0., 40., 80), y = even_lines(0., 10., 20);
  const std::unique_ptr<Mesh> wide = tensor_mesh(
      x, y, [](const dealii::Point<dim>&) { return "soil"; },
      [](const dealii::Point<dim>& p) {
        return p[0] < 1e-9         ? "left"
               : p[0] > 40. - 1e-9 ? "right"
               : p[1] < 1e-9       ? "base"
               : p[1] > 10. - 1e-9 ? "top"
                                   : "";
      });
  scene_.regions["soil"].stress_law->exponent = 0.;
  const StaticStage bare = solve_static(scene_, *wide);
  scene_.initial->surcharge["berm"] = {"top", 30e3, 12.3, 19.45};
  const StaticStage loaded = solve_static(scene_, *wide);
  for (const double level : {1.25, 4.75}) {
    double sum = 0.;
    for (const auto& cell : wide->triangulation.active_cell_iterators())
      if (const std::size_t i = cell->active_cell_index(); std::abs(centre_y(cell) - level) < 1e-6)
        sum += 0.5 * (loaded.stress.vertical[i] - bare.stress.vertical[i]);
    EXPECT_NEAR(sum, 30e3 * 7.15, 2e-4 * 30e3 * 7.15) << level;
  }
}

TEST_F(Strip, OnAHalfPlaneIsFlamants) {
  const std::unique_ptr<Mesh> ground = mesh();
  const StaticStage loaded = solve_static(scene(q / (9.81 * thickness) + 1e-3), *ground);
  const StaticStage bare = solve_static(scene(1e-3), *ground);
  int looked = 0;
  for (const auto& cell : ground->triangulation.active_cell_iterators()) {
    const double x = cell->center()[0], z = -cell->center()[1];
    if (z < 0.3 * b || z > 4. * b || std::abs(x) > 2. * b) continue;
    const std::size_t i = cell->active_cell_index();
    const double angle = std::atan((x + b) / z) - std::atan((x - b) / z);
    const double mean = (1. + nu) / 3. * 2. * q / pi * angle;
    const double found = loaded.stress.mean(i, {}) - bare.stress.mean(i, {});
    EXPECT_NEAR(found, mean, 0.005 * (1. + nu) / 3. * 2. * q) << "x " << x << ", z " << z;
    ++looked;
  }
  EXPECT_GT(looked, 200);
}

TEST(StaticStage, OfABreakwaterCarriesTheCaissonsBuoyantWeight) {
  Scene scene = breakwater(triangle(1., 0.1));
  add_sea(scene);
  for (const char* name : {"seabed", "mound"}) {
    scene.regions[name].shear_modulus.reset();
    scene.regions[name].stress_law = StressLaw{60e6, 98e3, 0.5, {}};
  }
  const auto mesh = breakwater_mesh(0.5, with_sea());
  const StaticStage stage = solve_static(scene, *mesh);
  EXPECT_NEAR(water_level(scene, *mesh), 15., 1e-9);
  // below the seabed's top the vertical stress adds up to all weights above that level, far sides carrying their own
  double weight = 0., row = 1e300;
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    if (mesh->surface_of(cell) == "seabed") row = std::min(row, cell->center()[1]);
  for (const auto& cell : mesh->triangulation.active_cell_iterators()) {
    if (mesh->surface_of(cell) != "seabed" || std::abs(cell->center()[1] - row) > 1e-6) continue;
    const double width = cell->bounding_box().side_length(0);
    const double own = 0.6 * (2650. - 1030.) * 9.81 * -cell->center()[1];
    weight += width * (stage.stress.vertical[cell->active_cell_index()] - own);
  }
  const double caisson = (2100. * 16. - 1030. * 9.) * 18. * 9.81;
  const double mound = 0.6 * (2650. - 1030.) * 9.81 * 6. * (16. + 28.);
  EXPECT_NEAR(weight, caisson + mound, 0.005 * (caisson + mound));
}

TEST(StaticStage, IsNotNeededWhereStiffnessIsGiven) {
  EXPECT_FALSE(needs_static_stage(breakwater(triangle(1., 0.1))));
}

}  // namespace static_stage_test
}  // namespace upbead::test
