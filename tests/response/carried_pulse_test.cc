// Claims: cells of degree p change the wave number by its share p!^2/(2p)!^2 (k h)^(2p)/(4p + 2), and represent an
// evanescent wave as accurately; with sdirk4 and generalised-alpha the frequency has an error of order 4 and 2; the
// error of a march of a column is within a factor of the estimate: stress and pressure over the load's largest value,
// at any point of a cell. Source: Ainsworth (2004), Discrete dispersion relation for hp-version finite element
// approximation at high wave number, SIAM J. Numer. Anal. 42, 553-575.
#include "response/carried_pulse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/plane_waves.h"
#include "scenes.h"

namespace upbead::test {
namespace carried_pulse_test {

using Complex = std::complex<double>;

TEST(CarriedOverCell, IsDelayedAsAinsworthTells) {
  const double coefficients[] = {1. / 24., 1. / 1440., 1. / 201600.};
  for (int p = 1; p <= 3; ++p) {
    const double k = 0.25 * p;  // rad in a cell of 1 m
    const double carried = -std::arg(carried_over_cell(Complex(-k * k, 1e-9), {1., p, {}}));
    EXPECT_NEAR((k - carried) / (coefficients[p - 1] * std::pow(k, 2 * p + 1)), 1., 0.05) << p;
    EXPECT_NEAR(std::abs(carried_over_cell(0.04, {1., p, {}})) / std::exp(-0.2), 1., 1e-3) << p;
  }
}

TEST(SteppedFrequency, IsWrongByTheOrderOfTheScheme) {
  for (const int order : {2, 4}) {
    double error[2];
    for (const int i : {0, 1}) {
      SteppedFrequency felt({i == 0 ? 0.02 : 0.01, order});
      const Complex s(0., 10.);
      error[i] = std::abs(felt(s) - s);
    }
    EXPECT_NEAR(std::log2(error[0] / error[1]), order, 0.2);
  }
  SteppedFrequency felt({0.1, 4});
  EXPECT_TRUE(felt.feels({0., 31.}));
  EXPECT_FALSE(felt.feels({0., 32.}));
}

struct ColumnOf {
  double conductivity;  ///< m/s; 0: dry
  int degree;
  double cells;  ///< number of cells that the wave passes in half the duration of the load
  double step;   ///< over that duration; 0: a 256th
};

/// Largest error of a march against one with 8 times as many cells and short steps, over the load; and its estimate.
struct Found {
  double measured, told;
};

Scene scene_of(const ColumnOf& at, double duration) {
  Region soil = rubble();
  soil.damping.reset();
  soil.flow = at.conductivity > 0. ? Flow::inertial : Flow::drained;
  soil.hydraulic_conductivity = at.conductivity > 0. ? at.conductivity : 1.;
  Scene scene = column(soil, triangle(1., duration));
  scene.mesh.degree = at.degree;
  for (const double y : {7.13, 16.09, 25.41}) scene.probes["p" + std::to_string(static_cast<int>(y))].at = {0.5, y};
  return scene;
}

std::vector<Eigen::RowVectorXd> histories(const Scene& scene, int cells, double end, double step, int each) {
  const auto mesh = column_mesh(32., cells);
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, end, step);
  std::vector<Eigen::RowVectorXd> list;
  for (const auto& [name, probe] : scene.probes) {
    const bool wet = scene.regions.at("soil").flow == Flow::inertial;
    const Eigen::RowVectorXd all =
        history(compiled, response, "probes/" + name + (wet ? "/pressure" : "/effective_stress_yy"));
    list.emplace_back(all(Eigen::seq(0, all.size() - 1, each)));
  }
  return list;
}

Found find(const ColumnOf& at) {
  constexpr int n_cells = 32, n_steps = 256, passes = 4;
  Region soil = scene_of(at, 1.).regions.at("soil");
  const Material m = material(soil, Fluid(), 9.81);
  const WaveLaw law = [&](Complex s) {
    const PlaneWaves waves = plane_waves(m, soil.flow, s);
    return at.conductivity > 0. ? waves.slow : waves.fast;
  };
  const int carried_by = at.conductivity > 0. ? at.degree - 1 : at.degree;
  const double speed = carried_speed(law, 0., {1., carried_by, {}}), duration = 2. * at.cells / speed;
  const double end = passes * 32. / speed, fine = duration / n_steps;
  const int each = at.step > 0. ? static_cast<int>(std::lround(at.step * n_steps)) : 1;
  const Scene scene = scene_of(at, duration);
  const double whole = std::ceil(end / (each * fine)) * each * fine;
  const auto coarse = histories(scene, n_cells, whole, each * fine, 1);
  const auto exact = histories(scene, 8 * n_cells, whole, fine, each);
  Found found{0., carried_error(law, duration, {1., carried_by, {each * fine, 4}}, 1., speed * end)};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Eigen::Index n = std::min(coarse[i].size(), exact[i].size());
    found.measured = std::max(found.measured, (coarse[i].head(n) - exact[i].head(n)).cwiseAbs().maxCoeff());
  }
  return found;
}

class CarriedError : public testing::TestWithParam<ColumnOf> {};

TEST_P(CarriedError, IsThatOfAMarch) {
  const Found found = find(GetParam());
  EXPECT_GT(found.told, 0.5 * found.measured);
  EXPECT_LT(found.told, 3. * found.measured);
  RecordProperty("measured", std::to_string(found.measured));
  RecordProperty("told", std::to_string(found.told));
}

INSTANTIATE_TEST_SUITE_P(Columns, CarriedError,
                         testing::Values(ColumnOf{0., 2, 4., 0.}, ColumnOf{0., 3, 8., 0.125},
                                         ColumnOf{0.3, 2, 4., 0.}));
INSTANTIATE_TEST_SUITE_P(ColumnsAtLength, CarriedError,
                         testing::Values(ColumnOf{0., 2, 1., 0.}, ColumnOf{0., 3, 2., 0.}, ColumnOf{1e3, 2, 4., 0.},
                                         ColumnOf{1e3, 3, 4., 0.}));

TEST(CarriedError, IsFollowedForFourHundredCells) {
  Region stones = rubble();
  stones.damping.reset();
  const Material m = material(stones, Fluid(), 9.81);
  const WaveLaw law = [&](Complex s) { return plane_waves(m, Flow::drained, s).fast; };
  const double duration = 8. / carried_speed(law, 0., {1., 2, {}});
  const auto error = [&](double most) { return carried_error(law, duration, {1., 2, {}}, 1., most); };
  EXPECT_LT(error(10.), error(400.));
  EXPECT_EQ(error(4000.), error(400.));
}

/// Chung and Hulbert 1993: at an infinite frequency all three roots of generalised-alpha are -rho_inf, here -0.9. So
/// near that root the square of the frequency grows as the distance from it to the power -3.
TEST(SteppedFrequency, OfGeneralisedAlphaHasAThreefoldRootAtInfinity) {
  const Complex at_infinity = std::log(Complex(-0.9, 0.));
  const auto square = [&](double distance) {
    SteppedFrequency stepped({1., 2});
    return std::norm(stepped(at_infinity + distance));
  };
  EXPECT_NEAR(square(1e-4) / square(1e-3), 1e3, 10.);
  SteppedFrequency slow({1e-3, 2});
  EXPECT_NEAR(std::abs(slow({-1., 3.}) - Complex(-1., 3.)), 0., 1e-5) << "short steps carry it as it is";
}

}  // namespace carried_pulse_test
}  // namespace upbead::test
