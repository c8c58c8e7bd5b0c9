// Claim: without inertia consolidation of a layer of soil under a uniform strip load is right in two dimensions: pore
// pressures on the axis, whose maximum moves downwards and, for nu = 0, rises before it falls (Mandel's effect), and
// settlements of the surface.
// Source: tests/reference/ref1_consolidation.json, `strip` (Fourier and Laplace transforms of the exact layer; rough
// rigid impervious base, drained surface). The layer is 8 depths wide, its cells grow from 0.1 m at the load's edge
// and at the drained surface. Limits: at every tabulated time, all of which lie past the first steps, 0.1 % of the
// largest pressure of the first row (the initial pressure apart from its drained skin), and of the largest
// settlement.

#include <gtest/gtest.h>

#include <algorithm>

#include "loaded_layer.h"
#include "record.h"

namespace upbead::test {
namespace strip_consolidation_test {

/// Steps that grow tenfold from one segment to the next up to the first time of the table, then 10 between its times.
TimeGrid steps_through(const std::vector<double>& times) {
  std::vector<double> ends;
  for (const double part : {1e-3, 1e-2, 1e-1}) ends.push_back(part * times.front());
  ends.insert(ends.end(), times.begin(), times.end());
  TimeGrid grid;
  for (const double end : ends) {
    grid.segments.push_back({grid.end, (end - grid.end) / 10., 10});
    grid.end = end;
  }
  return grid;
}

/// Values at the points and times of a table; rows in time, columns in space.
struct Comparison {
  std::vector<std::vector<double>> exact, computed;
  double largest(double scale) const {
    double worst = 0.;
    for (std::size_t i = 0; i < exact.size(); ++i) worst = std::max(worst, largest_error(computed[i], exact[i], scale));
    return worst;
  }
};

Comparison compare(const Compiled& compiled, const Response& response, const std::string& prefix,
                   const std::string& reading, double sign, const Json& rows, const std::vector<double>& times) {
  Comparison out;
  for (std::size_t i = 0; i < rows.at(0).size(); ++i) {
    out.exact.push_back(column_of(rows, i));
    const auto values = history(compiled, response, "probes/" + prefix + std::to_string(i) + reading);
    out.computed.push_back(sampled(response.ends.time, sign * values, times));
  }
  return out;
}

class StripConsolidation : public ::testing::TestWithParam<unsigned> {};

TEST_P(StripConsolidation, PressuresAndSettlements) {
  const Json entry = reference("ref1_consolidation").at("strip").at(GetParam());
  const std::vector<double> t = entry.at("t"), x = entry.at("x"), z = entry.at("z");
  Scene scene = loaded_layer(soil(entry.at("mat"), Flow::darcy), entry.at("q"), PressureCondition::open);
  scene.fluid = fluid(entry.at("mat"));
  scene.mesh.degree = 3;
  add_probes_at_depths(scene, "axis", z);
  add_probes_on_surface(scene, "surface", x);
  const auto mesh = graded_layer_mesh({entry.at("b"), entry.at("H"), 8.}, 0.1, 1.3, 1.25);
  const Compiled compiled(scene, *mesh);
  const auto scheme = make_scheme(compiled.system, {});
  const Response response = march(compiled.system, *scheme, steps_through(t));

  const auto p = compare(compiled, response, "axis", "/pressure", 1., entry.at("p_centreline"), t);
  const auto u = compare(compiled, response, "surface", "/displacement_y", -1., entry.at("u_z_surface"), t);
  const std::vector<double> first = entry.at("p_centreline").at(0);
  const double initial = *std::max_element(first.begin(), first.end());
  double settlement = 0.;
  for (const auto& point : u.exact) settlement = std::max(settlement, *std::max_element(point.begin(), point.end()));
  Record record("strip_consolidation");
  const std::string name = "nu = " + entry.at("mat").at("nu").dump() + ": ";
  record.at_most(name + "p on the axis, all depths and times, over the largest initial pressure", p.largest(initial),
                 1e-3);
  record.at_most(name + "settlement of the surface, all points and times, over the largest", u.largest(settlement),
                 1e-3);
  for (std::size_t i = 0; i < z.size(); ++i)
    record.curve({name + "p on the axis", "time (s) (log)", "p (Pa)", "z = " + entry.at("z").at(i).dump() + " m", t,
                  p.exact[i], p.computed[i]});
}

INSTANTIATE_TEST_SUITE_P(Cases, StripConsolidation, ::testing::Values(0u));
INSTANTIATE_TEST_SUITE_P(CasesAtLength, StripConsolidation, ::testing::Values(1u));

}  // namespace strip_consolidation_test
}  // namespace upbead::test
