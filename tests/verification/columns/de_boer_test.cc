// Claim: the response of a half-space of incompressible grains and water to a step, a periodic load and a triangle is
// that of the closed form, at four depths, with inertial flow (`full`) and darcy flow (`upB`).
// Source: tests/reference/ref2a_deboer.json (de Boer, Ehlers and Liu 1993). The column is 30 m deep: the front (85 or
// 108 m/s) that its base reflects has not reached the deepest point of the tables (5 m) at their end (0.5 s). Limits:
// u 0.2 % and p 1 % of their largest values. Under a step p jumps at the front; points within half a metre of it are
// left out for p.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "column_case.h"

namespace upbead::test {
namespace de_boer_test {

constexpr double depth = 30.;            // m
constexpr double deepest = 5.;           // m, of the tables
constexpr double blurred_by_front = .5;  // m

TimeFunction load_of(const Json& result) {
  const double q = result.at("q");
  if (result.contains("td")) return triangle(q, result.at("td"));
  if (!result.contains("omega")) return step_load(q);
  const double omega = result.at("omega");
  return TimeFunction({0.},
                      {[](double) { return 0.; }, [q, omega](double t) { return q * (1. - std::cos(omega * t)); }});
}

/// Cells of the size h down to the deepest point of the tables, where fronts must stay sharp; below, cells grow.
std::vector<double> mesh_lines(double h) {
  const double from = depth - deepest - 0.5;
  return joined(graded_lines(from, 0., h, 1.05, depth), graded_lines(from, depth, h, 1., h));
}

std::string probe_at(double z) {
  return "z" + std::to_string(std::lround(1e3 * z));
}

/// All values of a table of depths that count, row after row, and the computed ones.
struct Values {
  std::vector<double> computed, exact;
};

/// `front`: the front's speed (m/s) if it is sharp, else 0.
Values values_of(const ColumnRun& run, const Json& rows, const std::string& key, const std::vector<double>& t,
                 double front) {
  Values out;
  for (const Json& row : rows) {
    const double z = row.at("z");
    const std::string reading = "probes/" + probe_at(z) + (key == "u" ? "/displacement_y" : "/pressure");
    const std::vector<double> computed = run.at(reading, t), exact = row.at(key);
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (front > 0. && std::abs(z - front * t[i]) < blurred_by_front) continue;
      out.computed.push_back(key == "u" ? -computed[i] : computed[i]);
      out.exact.push_back(exact[i]);
    }
  }
  return out;
}

class DeBoer : public ::testing::TestWithParam<std::tuple<unsigned, unsigned>> {
 protected:
  DeBoer()
      : entry_(reference("ref2a_deboer").at("cases").at(std::get<0>(GetParam()))),
        result_(entry_.at("results").at(std::get<1>(GetParam()))),
        t_(result_.at("t").get<std::vector<double>>()),
        is_step_(result_.at("load") == "step") {}

  ColumnRun march_column(const std::vector<double>& depths) const {
    Json constants = entry_.at("material");
    constants["k"] = entry_.at("k");
    Scene scene = column(soil(constants, flow_of(entry_.at("model"))), load_of(result_));
    scene.gravity = constants.at("g");
    scene.fluid = fluid(constants);
    for (const double z : depths) scene.probes[probe_at(z)].at = {0.5, depth - z};
    const double end = t_.back();
    if (is_step_) return ColumnRun(scene, {mesh_lines(0.03), 3, end / 1500.}, end);
    // Smooth loads have no front, but a drained skin of some centimetres.
    return ColumnRun(scene, {geometric_lines(depth, 120, 100.), 3, end / 1000.}, end);
  }

  Json entry_, result_;
  std::vector<double> t_;
  bool is_step_;
};

TEST_P(DeBoer, HalfSpace) {
  Json u_rows = result_.at("u_z");
  if (result_.contains("u_top")) u_rows.push_back({{"z", 0.}, {"u", result_.at("u_top")}});
  const Json p_rows = result_.value("p_z", Json::array());
  std::vector<double> depths;
  for (const Json& rows : {u_rows, p_rows})
    for (const Json& row : rows) depths.push_back(row.at("z"));
  const ColumnRun run = march_column(depths);

  Record record("de_boer");
  const std::string name = result_.at("load").get<std::string>() + ", k = " + entry_.at("k").dump() + " m/s, " +
                           entry_.at("model").get<std::string>();
  const Values u = values_of(run, u_rows, "u", t_, 0.);
  record.at_most(name + ": u at all depths over its largest value", largest_error(u.computed, u.exact), 2e-3);
  if (p_rows.empty()) return;
  const Values p = values_of(run, p_rows, "p", t_, is_step_ ? entry_.at("wave_speed").get<double>() : 0.);
  ASSERT_GT(p.exact.size(), 40u);
  record.at_most(name + ": p over its largest value, " + std::to_string(p.exact.size()) + " of " +
                     std::to_string(t_.size() * p_rows.size()) + " points",
                 largest_error(p.computed, p.exact), 1e-2);
  if (entry_.at("k") != 0.01) return;
  for (const Json& row : p_rows)
    record.curve({name, "time (s)", "p (Pa)", "z = " + row.at("z").dump() + " m", t_, row.at("p"),
                  run.at("probes/" + probe_at(row.at("z")) + "/pressure", t_)});
}

/// Cases 0, 3, 6 are `full`, 2, 5, 8 `upB`; the program does not solve upA.
const auto by_case = [](const ::testing::TestParamInfo<std::tuple<unsigned, unsigned>>& p) {
  return std::to_string(std::get<0>(p.param)) + "_" + std::to_string(std::get<1>(p.param));
};

INSTANTIATE_TEST_SUITE_P(Cases, DeBoer, ::testing::Combine(::testing::Values(0u, 2u), ::testing::Values(1u, 2u)),
                         by_case);
INSTANTIATE_TEST_SUITE_P(StepsAtLength, DeBoer, ::testing::Combine(::testing::Values(0u, 2u), ::testing::Values(0u)),
                         by_case);
INSTANTIATE_TEST_SUITE_P(CasesAtLength, DeBoer,
                         ::testing::Combine(::testing::Values(3u, 5u, 6u, 8u), ::testing::Values(0u, 1u, 2u)), by_case);

}  // namespace de_boer_test
}  // namespace upbead::test
