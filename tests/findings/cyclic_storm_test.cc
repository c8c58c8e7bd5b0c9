// Claims: residual pressure over depth and time is that of the series solution of diffusion with a source, of order 2
// in cells and in steps; after a storm it goes as Terzaghi's table says; where no water leaves, N cycles build N/N_l of
// the effective stress, and no more than all of it; with soil that liquefies, layers and a source by depth it is that
// of an independent computation by finite differences; water is neither lost nor made; cells of a survey's mesh,
// hanging nodes, layers beside each other and other units change nothing.
#include "response/cyclic_storm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace cyclic_storm_test {

constexpr double pi = 3.14159265358979323846, H = 8., period = 10.;

/// A column with its diffusion: storage S, mobility k/(rho_f g).
struct Column {
  std::unique_ptr<Mesh> mesh;
  Compiled compiled;
  PoreFlow flow;
  double S = 0., mobility = 0., c = 0.;

  Column(const Scene& scene, std::unique_ptr<Mesh> on)
      : mesh(std::move(on)), compiled(scene, *mesh), flow(pore_flow(compiled.space, compiled.resolved)) {
    const Material& m = compiled.space.material(compiled.space.dofs().begin_active());
    S = 1. / m.constrained_modulus() + m.storage;
    mobility = 1. / m.b;
    c = mobility / S;
  }
  double depth(std::size_t cell) const { return H - flow.middle[cell][1]; }
};

Scene column_scene(bool open = true) {
  Scene scene = column(sand(), triangle(1e3, 1.));
  scene.regions["soil"].hydraulic_conductivity = 1e-5;
  scene.boundaries["top"].pressure = open ? PressureCondition::open : PressureCondition::sealed;
  return scene;
}

Column even_column(int cells, bool open = true) {
  return Column(column_scene(open), column_mesh(H, cells));
}

Cycles one_part(double number, double calm = 0.) {
  Cycles cycles;
  cycles.number = {number};
  cycles.period = {period};
  cycles.calm = calm;
  return cycles;
}

/// Cells whose source is f(depth) (Pa/s), whatever their effective stress, which is so large that nothing liquefies:
/// beta = -1 makes a pressure of tau/alpha in a cycle.
std::vector<StormCell> with_source(const Column& column, const std::function<double(double)>& f) {
  std::vector<StormCell> cells(column.mesh->triangulation.n_active_cells());
  for (std::size_t c = 0; c < column.flow.cells.size(); ++c) {
    StormCell& cell = cells[column.flow.cells[c]];
    cell.counts = true;
    cell.effective_stress = 1e12;
    cell.strength = CyclicStrength{1., -1.};
    cell.shear = f(column.depth(c)) * period;
  }
  return cells;
}

/// p' = c p_zz + F exp(-l z), p = 0 at z = 0, sealed at z = H, from p = 0, as a series of sines.
double series(double z, double t, double c, double F, double l) {
  double sum = 0.;
  for (int n = 1; n <= 4000; ++n) {
    const double m = (n - 0.5) * pi / H;
    // (2/H) integral of exp(-l z) sin(m z); cos(m H) = 0, sin(m H) = (-1)^(n+1)
    const double f = 2. / H * F * (m - l * std::exp(-l * H) * (n % 2 == 1 ? 1. : -1.)) / (l * l + m * m);
    sum += f * std::sin(m * z) * -std::expm1(-c * m * m * t) / (c * m * m);
  }
  return sum;
}

/// Largest difference from the series over its largest value, when the storm ends after `share` of H^2/c.
double error_against_series(int cells, double share, int steps, double grading = 1.) {
  const Column column(column_scene(), column_mesh(H, cells, grading));
  const double l = 0.4, F = 20.;
  const double number = share * H * H / column.c / period;
  const StormFound found = run_storm(column.flow, one_part(number),
                                     with_source(column, [&](double z) { return F * std::exp(-l * z); }), steps);
  double largest = 0., error = 0.;
  for (std::size_t c = 0; c < column.flow.cells.size(); ++c) {
    const double exact = series(column.depth(c), number * period, column.c, F, l);
    largest = std::max(largest, exact);
    error = std::max(error, std::abs(found.pressure[column.flow.cells[c]] - exact));
  }
  return error / largest;
}

TEST(CyclicStorm, IsTheSeriesSolution) {
  for (const double share : {0.003, 0.03, 0.3, 3.}) EXPECT_LT(error_against_series(100, share, 64, 20.), 1e-3) << share;
}

TEST(CyclicStorm, ConvergesWithTheSquareOfTheCells) {
  const double coarse = error_against_series(10, 0.3, 256), fine = error_against_series(20, 0.3, 256),
               finest = error_against_series(40, 0.3, 256);
  EXPECT_NEAR(std::log2(coarse / fine), 2., 0.15);
  EXPECT_NEAR(std::log2(fine / finest), 2., 0.15);
}

TEST(CyclicStorm, ConvergesWithTheSquareOfTheSteps) {
  const Column column = even_column(40);
  const double number = 0.3 * H * H / column.c / period;
  const auto cells = with_source(column, [](double z) { return 20. * std::exp(-0.4 * z); });
  const auto at = [&](int steps) {
    Cycles cycles = one_part(number);
    return run_storm(column.flow, cycles, cells, steps).pressure[column.flow.cells[20]];
  };
  const double finest = at(512);
  const double coarse = std::abs(at(4) - finest), fine = std::abs(at(8) - finest), finer = std::abs(at(16) - finest);
  EXPECT_NEAR(std::log2(coarse / fine), 2., 0.35);
  EXPECT_NEAR(std::log2(fine / finer), 2., 0.35);
  EXPECT_LT(std::abs(at(64) - finest) / finest, 1e-4);
}

/// Degree of consolidation over T_v = c t/H^2 with one drained end and even pressure at first: the table of Taylor
/// (Fundamentals of Soil Mechanics, 1948), which every textbook has, in its three digits.
TEST(CyclicStorm, GoesAsTerzaghisTableSays) {
  const Column column(column_scene(), column_mesh(H, 120, 1000.));
  const auto cells = with_source(column, [](double) { return 1e5; });
  for (const auto& [T, U] : std::vector<std::pair<double, double>>{{0.031, 0.20},
                                                                   {0.071, 0.30},
                                                                   {0.126, 0.40},
                                                                   {0.197, 0.50},
                                                                   {0.287, 0.60},
                                                                   {0.403, 0.70},
                                                                   {0.567, 0.80},
                                                                   {0.848, 0.90}}) {
    const double second = H * H / column.c;
    const StormFound found = run_storm(column.flow, one_part(1e-6 * second / period, T * second), cells);
    EXPECT_NEAR(1. - found.stored / found.source, U, 1.5e-3) << T;
  }
}

/// Wave by wave, for soil under its own weight: sigma'_0 = gamma' z (1 + 2 K_0)/3, tau over it as given by depth.
std::vector<StormCell> sand_cells(const Column& column, const std::function<double(double)>& stress_ratio,
                                  double gradient = 6e3) {
  std::vector<StormCell> cells(column.mesh->triangulation.n_active_cells());
  for (std::size_t c = 0; c < column.flow.cells.size(); ++c) {
    StormCell& cell = cells[column.flow.cells[c]];
    cell.counts = true;
    cell.effective_stress = gradient * column.depth(c);
    cell.strength = CyclicStrength{0.254, -0.275};
    cell.shear = stress_ratio(column.depth(c)) * cell.effective_stress;
    cell.modulus = 30e6;
  }
  return cells;
}

TEST(CyclicStorm, BuildsTheShareOfCyclesWhereNoWaterLeaves) {
  Scene scene = column_scene(false);
  scene.regions["soil"].hydraulic_conductivity = 1e-14;
  const Column column(scene, column_mesh(H, 20));
  const auto cells = sand_cells(column, [](double) { return 0.08; });
  const double N = CyclicStrength{0.254, -0.275}.cycles_to_liquefy(0.08);
  const StormFound half = run_storm(column.flow, one_part(0.5 * N), cells);
  for (const unsigned cell : column.flow.cells) EXPECT_NEAR(half.largest_ratio[cell], 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(half.liquefied_at[column.flow.cells[3]]));
  const StormFound twice = run_storm(column.flow, one_part(2. * N), cells);
  for (const unsigned cell : column.flow.cells) {
    EXPECT_NEAR(twice.largest_ratio[cell], 1., 1e-6);
    EXPECT_NEAR(twice.liquefied_at[cell], N * period, 0.03 * N * period);
  }
  EXPECT_NEAR(twice.shed, 0.5 * twice.source, 0.01 * twice.source);
  EXPECT_NEAR(twice.source, twice.stored + twice.outflow + twice.shed, 1e-10 * twice.source);
}

/// Miner's rule: shares of the lives of all parts add.
TEST(CyclicStorm, AddsTheSharesOfPartsWhereNoWaterLeaves) {
  Scene scene = column_scene(false);
  scene.regions["soil"].hydraulic_conductivity = 1e-14;
  const Column column(scene, column_mesh(H, 10));
  const auto cells = sand_cells(column, [](double) { return 0.08; });
  Cycles storm;
  storm.number = {30., 4., 50.};
  storm.period = {8., 12., 9.};
  storm.height = {2., 4., 1.5};
  storm.run_height = 4.;
  double life = 0.;
  for (std::size_t i = 0; i < 3; ++i)
    life += storm.number[i] / CyclicStrength{0.254, -0.275}.cycles_to_liquefy(0.08 * storm.height[i] / 4.);
  ASSERT_LT(life, 1.);
  const StormFound found = run_storm(column.flow, storm, cells);
  for (const unsigned cell : column.flow.cells)
    EXPECT_NEAR(found.pressure[cell] / cells[cell].effective_stress, life, 1e-6 * life);
}

/// Explicit finite differences over depth, nodes half a step from both ends: pressure, source until p = sigma'_0, and a
/// conductivity by depth. Shares no code with the program.
std::vector<double> by_differences(int n, double end, double S, const std::function<double(double)>& mobility,
                                   const std::function<double(double)>& source,
                                   const std::function<double(double)>& cap) {
  const double h = H / n;
  std::vector<double> p(static_cast<std::size_t>(n), 0.), next = p;
  double fastest = 0.;
  for (int i = 0; i < n; ++i) fastest = std::max(fastest, mobility((i + 0.5) * h));
  const int steps = static_cast<int>(std::ceil(end / (0.4 * h * h * S / fastest)));
  const double dt = end / steps;
  const auto between = [&](int i) {  // harmonic mean of the mobilities on both sides of the face above node i
    const double a = mobility((i - 0.5) * h), b = mobility((i + 0.5) * h);
    return 2. * a * b / (a + b);
  };
  for (int s = 0; s < steps; ++s) {
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double above = i == 0 ? 2. * mobility(0.5 * h) * (0. - p[0]) : between(i) * (p[k - 1] - p[k]);
      const double below = i == n - 1 ? 0. : between(i + 1) * (p[k + 1] - p[k]);
      const double z = (i + 0.5) * h;
      next[k] = std::min(p[k] + dt * ((above + below) / (h * h * S) + source(z)), cap(z));
    }
    std::swap(p, next);
  }
  return p;
}

TEST(CyclicStorm, AgreesWithFiniteDifferencesWhereSoilLiquefies) {
  Scene scene = column_scene();
  scene.regions["soil"].hydraulic_conductivity = 1e-6;
  const Column column(scene, column_mesh(H, 80));
  const double gradient = 6e3, T = period;
  const auto ratio = [](double z) { return 0.16 * std::exp(-z / 6.); };
  const auto cells = sand_cells(column, ratio, gradient);
  Cycles cycles = one_part(200.);
  const StormFound found = run_storm(column.flow, cycles, cells, 256);
  const auto stress = [&](double z) { return gradient * z; };
  const std::vector<double> p = by_differences(
      160, cycles.number[0] * T, column.S, [&](double) { return column.mobility; },
      [&](double z) {
        return pressure_of_cycle({0.254, -0.275}, ratio(z) * stress(z), stress(z)) / T;
      },
      stress);
  double largest = 0.;
  int liquefied = 0;
  for (const double value : p) largest = std::max(largest, value);
  for (std::size_t c = 0; c < column.flow.cells.size(); ++c) {
    const auto i = static_cast<std::size_t>(column.depth(c) / H * 160.);  // the cell's middle lies between i - 1 and i
    EXPECT_NEAR(found.pressure[column.flow.cells[c]], 0.5 * (p[i - 1] + p[i]), 1e-3 * largest) << column.depth(c);
    liquefied += !std::isnan(found.liquefied_at[column.flow.cells[c]]);
  }
  EXPECT_GT(liquefied, 5);
  EXPECT_LT(liquefied, 75);
  EXPECT_GT(found.shed, 0.);
  EXPECT_NEAR(found.source, found.stored + found.outflow + found.shed, 1e-10 * found.source);
}

/// Sand between 2 and 5 m of depth under and over sand ten times as permeable; only the middle is sheared. The mesh is
/// uneven in both directions.
TEST(CyclicStorm, TakesLayersOnAMeshOfUnevenCells) {
  Scene scene = column_scene();
  scene.regions["layer"] = scene.regions["soil"];
  scene.regions["layer"].hydraulic_conductivity = 1e-6;
  const auto lines = joined(even_lines(0., 3., 24), joined(even_lines(3., 6., 60), even_lines(6., 8., 20)));
  Column column(
      scene, tensor_mesh(
                 {0., 0.3, 1.1, 1.2, 2.5}, lines,
                 [](const dealii::Point<dim>& at) { return std::string(at[1] > 3. && at[1] < 6. ? "layer" : "soil"); },
                 [](const dealii::Point<dim>& at) -> std::string {
                   if (at[1] < 1e-9) return "base";
                   if (at[1] > H - 1e-9) return "top";
                   if (at[0] < 1e-9) return "left";
                   return at[0] > 2.5 - 1e-9 ? "right" : "";
                 }));
  const auto inside = [](double z) { return z > 2. && z < 5.; };
  const auto f = [&](double z) { return inside(z) ? 15. * (z - 1.) : 0.; };
  const StormFound found = run_storm(column.flow, one_part(150.), with_source(column, f), 128);
  const double weak = 1e-6 / (1030. * 9.81), strong = 1e-5 / (1030. * 9.81);
  const std::vector<double> p = by_differences(
      160, 150. * period, column.S, [&](double z) { return inside(z) ? weak : strong; }, f,
      [](double) { return HUGE_VAL; });
  double largest = 0.;
  for (const double value : p) largest = std::max(largest, value);
  for (std::size_t c = 0; c < column.flow.cells.size(); ++c) {
    const double s = column.depth(c) / H * 160. - 0.5;
    const auto i = static_cast<std::size_t>(s);
    EXPECT_NEAR(found.pressure[column.flow.cells[c]], p[i] + (s - static_cast<double>(i)) * (p[i + 1] - p[i]),
                2e-3 * largest)
        << column.depth(c);
  }
}

/// Every second column of cells is halved.
TEST(CyclicStorm, TakesHangingNodes) {
  const auto pressure_at_depth = [](bool split) {
    auto mesh = column_mesh(H, 24);
    if (split) {
      for (const auto& cell : mesh->triangulation.active_cell_iterators())
        if (std::fmod(cell->center()[1], 2.) < 1.) cell->set_refine_flag();
      mesh->triangulation.execute_coarsening_and_refinement();
    }
    const Column column(column_scene(), std::move(mesh));
    const StormFound found =
        run_storm(column.flow, one_part(300.), with_source(column, [](double z) { return 20. * std::exp(-0.4 * z); }));
    EXPECT_NEAR(found.source, found.stored + found.outflow, 1e-10 * found.source);
    double integral = 0.;
    for (std::size_t c = 0; c < column.flow.cells.size(); ++c)
      integral += found.pressure[column.flow.cells[c]] * column.flow.area[c];
    return integral;
  };
  EXPECT_NEAR(pressure_at_depth(true), pressure_at_depth(false), 2e-3 * pressure_at_depth(false));
}

TEST(CyclicStorm, HasNoUnits) {
  const Column column = even_column(30);
  const auto cells = sand_cells(column, [](double z) { return 0.16 * std::exp(-z / 6.); });
  Cycles storm;
  storm.number = {500., 800.};
  storm.period = {9., 11.};
  storm.height = {2., 3.};
  storm.run_height = 3.;
  const StormFound pascals = run_storm(column.flow, storm, cells);
  PoreFlow flow = column.flow;  // in kPa
  flow.storage *= 1e3;
  flow.conductance *= 1e3;
  for (double& S : flow.cell_storage) S *= 1e3;
  auto in_kilo = cells;
  for (StormCell& cell : in_kilo) cell.effective_stress /= 1e3, cell.shear /= 1e3, cell.modulus /= 1e3;
  const StormFound kilo = run_storm(flow, storm, in_kilo);
  for (const unsigned cell : flow.cells) {
    EXPECT_NEAR(1e3 * kilo.pressure[cell], pascals.pressure[cell], 1e-8 * cells[cell].effective_stress);
    EXPECT_NEAR(kilo.largest_ratio[cell], pascals.largest_ratio[cell], 1e-8);
  }
  EXPECT_NEAR(kilo.source, pascals.source, 1e-10 * kilo.source);
}

TEST(CyclicStorm, HasPartsInOrderOfTime) {
  const Column column = even_column(30);
  const auto cells = with_source(column, [](double z) { return 20. * std::exp(-0.4 * z); });
  Cycles storm;
  storm.number = {100., 100.};
  storm.period = {period, period};
  storm.height = {1., 3.};
  storm.run_height = 3.;
  storm.calm = 0.;
  const StormFound rising = run_storm(column.flow, storm, cells);
  std::swap(storm.height[0], storm.height[1]);
  const StormFound falling = run_storm(column.flow, storm, cells);
  EXPECT_NEAR(rising.source, falling.source, 1e-9 * rising.source);  // as beta = -1 it is the sum of both
  EXPECT_GT(rising.stored, 1.05 * falling.stored);
  EXPECT_GT(falling.largest_ratio[column.flow.cells[0]], falling.pressure[column.flow.cells[0]] / 1e12);
  storm.number = {200.};
  storm.period = {period};
  storm.height = {3.};
  const StormFound whole = run_storm(column.flow, storm, cells);
  storm.number = {100., 100.};
  storm.period = {period, period};
  storm.height = {3., 3.};
  const StormFound halves = run_storm(column.flow, storm, cells);
  EXPECT_NEAR(halves.stored, whole.stored, 1e-4 * whole.stored);
}

TEST(CyclicStorm, FollowsTheCalmUntilLittleIsLeft) {
  const Column column = even_column(30);
  const auto cells = with_source(column, [](double z) { return 20. * std::exp(-0.4 * z); });
  Cycles storm = one_part(300.);
  storm.calm.reset();
  const StormFound found = run_storm(column.flow, storm, cells);
  EXPECT_LE(found.ratio.back(), 0.01 * *std::max_element(found.ratio.begin(), found.ratio.end()));
  EXPECT_LT(found.stored, 0.02 * found.source);
  double strained = 0.;
  for (std::size_t c = 0; c < column.flow.cells.size(); ++c)
    strained += found.drained[column.flow.cells[c]] * column.flow.area[c];
  EXPECT_NEAR(strained, found.source, 1e-10 * found.source);
}

}  // namespace cyclic_storm_test
}  // namespace upbead::test
