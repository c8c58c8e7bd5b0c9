// Claim: a caisson on rubble over sand, or on sand alone, transmits to its base the exact shear force and has the
// exact sway and rocking, with inertial flow everywhere (`full`) and with darcy flow (`upB`). One half is computed:
// the motion is antisymmetric.
// Source: tests/reference/ref2d_poro_strip.json (exact kernel of layers with three waves each, Galerkin contact), all
// triangles of 20 ms and longer. The mesh, chosen by trials: cells of 2 cm at the caisson's edge, degree 3; 200 m of
// ground beside the caisson, whose end absorbs.
// Limits: F_T, sway and rotation over their peaks 0.5 % at all tabulated times; peaks of F_T and base moment 0.2 % and
// 0.5 %.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "record.h"
#include "reference.h"
#include "strip_scene.h"

namespace upbead::test {
namespace poro_strip_test {

constexpr double shortest = 0.02;  // s

/// Cells fine enough for pulses of 20 ms.
StripCells cells() {
  StripCells cells;
  cells.edge = 0.02;
  cells.skin = 0.1;
  cells.growth = 4.;
  cells.along = 3.;
  cells.near = 10.;
  cells.far = 12.;
  cells.width = 200.;
  return cells;
}

constexpr double crossing = 0.002;  // s: the longest time in which a shear wave crosses a cell in height

/// Names of the soils, in the order of the table.
std::vector<std::string> soils(const Json& all) {
  std::vector<std::string> names;
  for (const Json& entry : all.at("cases"))
    if (const std::string name = entry.at("case"); std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

/// Layers with one fluid for all: if air makes the water of one layer more compressible, the compressibility of its
/// grains accounts for the difference.
std::vector<Layer> layers_of(const Json& entry, Flow flow, Fluid& fluid) {
  const Json& input = entry.at("layers_input");
  fluid = {input.at(0).at(0).at("rho_f"), 0.};
  for (const Json& layer : input) fluid.bulk_modulus = std::max(fluid.bulk_modulus, layer.at(0).at("Kf").get<double>());
  std::vector<Layer> layers;
  for (const Json& layer : input) {
    Region region = soil(layer.at(0), flow);
    const double K_f = layer.at(0).at("Kf"), n = layer.at(0).at("n");
    if (K_f < fluid.bulk_modulus) region.grain_bulk_modulus = (1. - n) / (n / K_f - n / fluid.bulk_modulus);
    const double c_s = std::sqrt(material(region, fluid, 9.81).G / material(region, fluid, 9.81).rho);
    layers.push_back({"layer" + std::to_string(layers.size()), layer.at(1), crossing * c_s, region});
  }
  return layers;
}

/// Compares one entry of the table with what the model found.
void compare(Record& record, const std::string& name, const Json& entry, const StripHistory& found) {
  const std::vector<double> t = entry.at("t");
  const double peak = entry.at("peak_FT");
  const auto at_table = [&](const Eigen::RowVectorXd& values) { return sampled(found.time, values, t); };
  const auto shear = at_table(found.shear);
  record.at_most(name + "F_T over its peak", largest_error(shear, entry.at("FT"), peak), 5e-3);
  record.at_most(name + "peak of F_T, relative", std::abs(found.peak_shear / peak - 1.), 2e-3);
  record.at_most(name + "sway over its peak", largest_error(at_table(found.sway), entry.at("sway")), 5e-3);
  record.at_most(name + "rotation over its peak", largest_error(at_table(found.rotation), entry.at("rotation")), 5e-3);
  record.at_most(name + "peak of the base moment, relative",
                 std::abs(found.moment.maxCoeff() / entry.at("peak_Mb").get<double>() - 1.), 5e-3);
  const double td = entry.at("td");
  if (td == 0.1)
    record.curve({entry.at("case"), "time (s)", "F_T / peak P", entry.at("model"), t, entry.at("FT"), shear});
}

class PoroStrip : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(PoroStrip, PassesTheForceOn) {
  const auto& [name, model] = GetParam();
  const Json all = reference("ref2d_poro_strip");
  std::unique_ptr<StripModel> strip;
  Record record("poro_strip");
  for (const Json& entry : all.at("cases")) {
    if (entry.at("case") != name || entry.at("model") != model || !entry.contains("td")) continue;
    const double td = entry.at("td");
    if (td < shortest) continue;
    if (!strip) {
      const Json& body = entry.at("caisson");
      const StripCaisson caisson{body.at("b"), body.at("m"), body.at("IG"), body.at("hG"), body.at("hP")};
      Fluid fluid;
      const auto layers = layers_of(entry, model == "full" ? Flow::inertial : Flow::darcy, fluid);
      strip = std::make_unique<StripModel>(caisson, layers, fluid, cells());
      strip->march_ramp(entry.at("t").back(), 0.00125);
    }
    std::ostringstream what;
    what << name << ", " << model << ", " << 1e3 * td << " ms: ";
    compare(record, what.str(), entry, strip->under_triangle(td));
  }
  ASSERT_TRUE(strip) << "no such case";
}

INSTANTIATE_TEST_SUITE_P(Soils, PoroStrip,
                         ::testing::Combine(::testing::ValuesIn(soils(reference("ref2d_poro_strip"))),
                                            ::testing::Values("full", "upB")),
                         [](const auto& p) {
                           std::string name = std::get<0>(p.param) + "_" + std::get<1>(p.param);
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

}  // namespace poro_strip_test
}  // namespace upbead::test
