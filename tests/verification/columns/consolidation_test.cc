// Claim: without inertia the program gives the consolidation of Terzaghi (1-D) and of Mandel (between smooth rigid
// plates, where the pressure in the centre rises before it falls), also with compressible grains.
// Source: tests/reference/ref1_consolidation.json (series, checked by Laplace inversion; Cheng and Detournay 1988).
// Limits: 0.1 % of the initial pressure, and of the largest displacement, at every tabulated time; all lie past the
// first steps.

#include <gtest/gtest.h>

#include <algorithm>

#include "column_case.h"
#include "unknowns_on.h"

namespace upbead::test {
namespace consolidation_test {

Region consolidating(const Json& entry) {
  Region region = soil(entry.at("mat"), Flow::darcy);
  region.biot = entry.at("derived").at("alpha");
  return region;
}

/// Equal steps between successive times, from t = 0 on: consolidation slows down, so steps may grow with the
/// intervals of the table.
TimeGrid through(const std::vector<double>& times, int steps_between) {
  TimeGrid grid;
  double start = 0.;
  for (const double t : times) {
    grid.segments.push_back({start, (t - start) / steps_between, steps_between});
    start = t;
  }
  grid.end = start;
  return grid;
}

Response consolidate(const System& system, const std::vector<double>& times, int steps_between) {
  const auto scheme = make_scheme(system, {});
  return march(system, *scheme, through(times, steps_between));
}

std::vector<double> read_at(const System& system, const Response& response, const std::string& reading,
                            const std::vector<double>& times) {
  return sampled(response.ends.time, response.ends.reading.row(system.reading(reading)), times);
}

/// Compares pressures at the points of a table, rows in time, columns in space; draws them over time.
void compare_pressures(Record& record, const std::string& name, const Json& entry, double initial, const System& system,
                       const Response& response) {
  const std::vector<double> t = entry.at("t"), x = entry.at("x");
  double worst = 0.;
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::vector<double> exact;
    for (const Json& row : entry.at("p")) exact.push_back(row.at(i));
    const auto computed = read_at(system, response, "probes/" + std::to_string(i) + "/pressure", t);
    worst = std::max(worst, largest_error(computed, exact, initial));
    record.curve(
        {name + "p", "time (s) (log)", "p (Pa)", "x = " + entry.at("x").at(i).dump() + " m", t, exact, computed});
  }
  record.at_most(name + "p at all points and times over its initial value", worst, 1e-3);
}

class Terzaghi : public ::testing::TestWithParam<unsigned> {};

TEST_P(Terzaghi, Consolidates) {
  const Json entry = reference("ref1_consolidation").at("terzaghi").at(GetParam());
  const double height = entry.at("L");
  Scene scene = column(consolidating(entry), step_load(entry.at("q")));
  scene.fluid = fluid(entry.at("mat"));
  scene.time.inertia = false;
  scene.probes["top"].at = {0.5, height};
  for (std::size_t i = 0; i < entry.at("x").size(); ++i)
    scene.probes[std::to_string(i)].at = {0.5, entry.at("x").at(i)};
  const std::vector<double> t = entry.at("t");
  const auto mesh = column_mesh(height, 60, 20.);
  const Compiled compiled(scene, *mesh);
  const Response response = consolidate(compiled.system, t, 20);
  Record record("terzaghi");
  const std::string name = "K_f = " + entry.at("mat").at("Kf").dump() + " Pa: ";
  compare_pressures(record, name, entry, entry.at("p0"), compiled.system, response);
  const auto u = read_at(compiled.system, response, "probes/top/displacement_y", t);
  record.at_most(name + "settlement over its largest value", largest_error(u, entry.at("u_top")), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Cases, Terzaghi, ::testing::Values(0u, 1u));

/// Between the ends of its steps, too, a column under a load that jumps settles ever further, and not beyond.
TEST(Terzaghi, SettlesWithoutTurningInsideCoarseSteps) {
  const Json entry = reference("ref1_consolidation").at("terzaghi").at(0);
  Scene scene = column(consolidating(entry), step_load(entry.at("q")));
  scene.fluid = fluid(entry.at("mat"));
  scene.time.inertia = false;
  scene.probes["top"].at = {0.5, entry.at("L")};
  const auto mesh = column_mesh(entry.at("L"), 60, 20.);
  const Compiled compiled(scene, *mesh);
  const std::vector<double> t = entry.at("t");
  const Response response = consolidate(compiled.system, {t[t.size() / 2]}, 6);
  const auto row = compiled.system.reading("probes/top/displacement_y");
  const auto ends = response.ends.reading.row(row), inside = response.inside.reading.row(row);
  ASSERT_EQ(response.inside.time.size(), 5u * 6u);
  for (Eigen::Index i = 0; i < inside.cols(); ++i) {
    const Eigen::Index step = i / 5;  // its ends are the columns step and step + 1, at rest first
    EXPECT_LE(inside[i], ends[step] + 1e-12) << response.inside.time[static_cast<std::size_t>(i)];
    EXPECT_GE(inside[i], ends[step + 1] - 1e-12) << response.inside.time[static_cast<std::size_t>(i)];
  }
}

/// A quarter of Mandel's specimen: symmetric about x = 0 and y = 0, drained and free at x = a, under a smooth plate.
Scene quarter_specimen(const Json& entry) {
  const double a = entry.at("a"), half_force = entry.at("F_half_total");
  Scene scene = column(consolidating(entry), step_load(half_force / a));
  scene.fluid = fluid(entry.at("mat"));
  scene.time.inertia = false;
  scene.mesh.degree = 3;
  scene.boundaries["base"] = {DisplacementCondition::roller, PressureCondition::sealed};
  scene.boundaries["right"] = {DisplacementCondition::free, PressureCondition::open};
  scene.boundaries["top"] = {DisplacementCondition::free, PressureCondition::sealed};
  for (std::size_t i = 0; i < entry.at("x").size(); ++i)
    scene.probes[std::to_string(i)].at = {entry.at("x").at(i), 0.5};
  scene.probes["edge"].at = {a, 1.};
  return scene;
}

class Mandel : public ::testing::TestWithParam<unsigned> {};

TEST_P(Mandel, Consolidates) {
  const Json entry = reference("ref1_consolidation").at("mandel").at(GetParam());
  const double a = entry.at("a"), initial = entry.at("p_initial");
  const auto mesh = tensor_mesh(
      graded_lines(a, 0., 0.01 * a, 1.1, 0.1 * a), {0., 1.}, [](const auto&) { return "soil"; },
      [a](const auto& at) -> std::string {
        if (at[1] == 0. || at[1] == 1.) return at[1] == 0. ? "base" : "top";
        return at[0] == 0. ? "left" : at[0] == a ? "right" : "";
      });
  const Compiled compiled(quarter_specimen(entry), *mesh);
  const System system = tied(compiled.system, unknowns_on(compiled, "top", 1));
  std::vector<double> t = entry.at("t");
  const Response response = consolidate(system, t, 40);
  Record record("mandel");
  const std::string name = "alpha = " + entry.at("derived").at("alpha").dump() + ": ";
  compare_pressures(record, name, entry, initial, system, response);
  record.at_most(name + "u_x of the edge over its largest value",
                 largest_error(read_at(system, response, "probes/edge/displacement_x", t), entry.at("ux_edge")), 1e-3);
  record.at_most(name + "u_y of the plate over its largest value",
                 largest_error(read_at(system, response, "probes/edge/displacement_y", t), entry.at("uy_per_height")),
                 1e-3);
  const double peak = response.ends.reading.row(system.reading("probes/0/pressure")).maxCoeff() / initial;
  const double exact = entry.at("centre_peak_p_over_p0");
  EXPECT_GT(peak, 1.05);
  record.at_most(name + "largest p in the centre, above its initial value, relative", std::abs(peak / exact - 1.),
                 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Cases, Mandel, ::testing::Values(0u, 1u));

}  // namespace consolidation_test
}  // namespace upbead::test
