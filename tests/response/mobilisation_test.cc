// Claims: in a drained column under its weight s'_x = nu/(1 - nu) s'_y, so that the same share of the strength is
// mobilised at all depths, (1 - K)/(1 + K)/sin phi, and no load on top changes that; with K_0 = 1 none is mobilised
// at rest, and a load mobilises the share by Mohr's circle in the highest cell that counts; for a tensile load the
// value is limited to 10. Strains of a reduced model are those of its states. Tolerance: round-off of the solution.
#include "response/monitors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace mobilisation_test {

constexpr double height = 10., nu = 0.33, angle = 35.;
constexpr int cells = 20;
const double K = nu / (1. - nu), sine = std::sin(angle * M_PI / 180.);

std::vector<MobilisedStrength> find(double load, const std::optional<double>& k0) {
  Region soil = sand();
  soil.flow = Flow::drained;
  soil.damping.reset();
  soil.strength = Strength{angle, 0.};
  Scene scene = column(soil, piecewise_linear({0., 1., 2.}, {0., load, load}));
  scene.time.inertia = false;
  scene.initial = InitialState{height, k0};
  const auto mesh = column_mesh(height, cells);
  const Compiled compiled(scene, *mesh);
  const StaticStage rest = solve_static(compiled.resolved, *mesh);
  Mobilisation mobilisation(compiled.space, compiled.unknowns, rest.stress, k0);
  const auto scheme = make_scheme(compiled.system);
  MarchOptions options;
  options.observers = {&mobilisation};
  march(compiled.system, *scheme, make_time_grid(kinks(compiled.system), 2., 0.5), options);

  Mobilisation resumed(compiled.space, compiled.unknowns, rest.stress, k0);
  resumed.recall(mobilisation.memory());
  EXPECT_EQ(resumed.found().at(0).largest, mobilisation.found().at(0).largest);
  return mobilisation.found();
}

TEST(Mobilisation, OfLateralEarthPressureIsTheSameEverywhere) {
  const auto found = find(5e4, {});
  ASSERT_EQ(found.size(), 1U);
  const double expected = (1. - K) / (1. + K) / sine;
  EXPECT_NEAR(found[0].initial, expected, 1e-6);
  EXPECT_NEAR(found[0].largest, expected, 1e-6);
  EXPECT_EQ(found[0].share, 0.);
  EXPECT_NEAR(found[0].left_out, 0.05, 1e-9);  // the highest cell, with 0.05 of the mean stress
}

TEST(Mobilisation, OfALoadIsThatOfMohrsCircle) {
  constexpr double q = 3e4;
  const auto found = find(q, 1.);
  const double depth = 1.5 * height / cells, unit_weight = 0.6 * (2650. - 1030.) * 9.81;
  const double r = 0.5 * (1. - K) * q, s = unit_weight * depth + 0.5 * (1. + K) * q;
  EXPECT_NEAR(found[0].initial, 0., 1e-6);
  EXPECT_NEAR(found[0].largest, r / (s * sine), 1e-6);
  EXPECT_NEAR(found[0].at[1], height - depth, 1e-9);
  EXPECT_GE(found[0].time, 1.);
}

TEST(Mobilisation, OfAPullEndsAtTen) {
  const auto found = find(-1e6, {});
  EXPECT_EQ(found[0].largest, 10.);
  EXPECT_NEAR(found[0].share, 0.95, 1e-9);
  EXPECT_EQ(found[0].initial_share, 0.);
}

TEST(MiddleStrains, OfAReducedModelAreThoseOfItsStates) {
  const auto mesh = column_mesh(height, cells);
  const Compiled compiled(column(sand(), piecewise_linear({0., 1.}, {0., 1.})), *mesh);
  const MiddleStrains strains(compiled.space, compiled.unknowns, std::vector<bool>(cells, true));
  int first = 0;  // the first unknown that strains a cell
  while (strains.shear(Vector::Unit(compiled.unknowns.size(), first)) == std::vector<double>(cells, 0.)) ++first;
  const int n = compiled.unknowns.size() - first;
  FieldBasis basis;
  for (int i = 0; i < n; ++i) basis.unknown.push_back(first + i);
  basis.unit = Vector::LinSpaced(n, 1., 2.);
  basis.vectors = (Vector::LinSpaced(n, 0.1, 3.) * Eigen::RowVector2d(1., 2.)).array().sin();
  basis.coordinate = {2, 0};
  const Eigen::MatrixXd coordinates{{1., -2., 0.5}, {7., 7., 7.}, {0.3, 0., -1.}};
  const Eigen::MatrixXd shear = strains.shear(basis, coordinates);
  const MiddleStrains::Series all = strains.at(basis, coordinates);
  ASSERT_EQ(shear.rows(), cells);
  for (int t = 0; t < 3; ++t) {
    Vector x = Vector::Zero(first + n);
    x.tail(n) = basis.unit.asDiagonal() * (basis.vectors * Eigen::Vector2d(coordinates(2, t), coordinates(0, t)));
    const std::vector<double> exact = strains.shear(x);
    const std::vector<PlaneStrain> parts = strains.at(x);
    for (int c = 0; c < cells; ++c) {
      const auto i = static_cast<std::size_t>(c);
      EXPECT_NEAR(shear(c, t), exact[i], 1e-12) << c;
      EXPECT_NEAR(all.yy(c, t), parts[i].yy, 1e-12) << c;
    }
  }
}

}  // namespace mobilisation_test
}  // namespace upbead::test
