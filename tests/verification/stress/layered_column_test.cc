// Claim: where rubble lies on sand of a thousandth of its conductivity, the solution on both sides is right, and the
// pressure in the sand does not oscillate from node to node.
// Source: tests/reference/ref9_stress.json, i (Laplace transform inverted numerically): a triangle of 100 ms. Limits:
// u 1e-3 and p 1e-2 of their largest values; p at the nodes in the sand differs by 1e-2 of its largest value from
// that on cells of half the size.

#include <gtest/gtest.h>

#include <cmath>

#include "stress_column.h"

namespace upbead::test {
namespace layered_column_test {

constexpr double rubble_thickness = 5., sand_thickness = 10.;  // m
constexpr double height = rubble_thickness + sand_thickness;

/// Cells grow away from both drained faces: the rubble's top and the interface, where the sand drains into the rubble.
std::vector<double> lines(double first) {
  return joined(graded_lines(sand_thickness, 0., first, 1.1, 0.25), even_lines(sand_thickness, height, 30));
}

class LayeredColumn {
 public:
  LayeredColumn(const Json& test, const std::string& model, const std::vector<double>& y)
      : mesh_(tensor_mesh(
            {0., 1.}, y, [](const auto& at) { return at[1] > sand_thickness ? "rubble" : "sand"; },
            [](const auto& at) -> std::string {
              if (at[1] == 0. || at[1] == height) return at[1] == 0. ? "base" : "top";
              return at[0] == 0. ? "left" : at[0] == 1. ? "right" : "";
            })),
        compiled_(scene(test, model, y), *mesh_),
        response_(run(compiled_, test.at("t").back(), 2.5e-4)) {}

  std::vector<double> at(const std::string& reading, const std::vector<double>& t) const {
    return sampled(response_.ends.time, history(compiled_, response_, reading), t);
  }

 private:
  static Scene scene(const Json& test, const std::string& model, const std::vector<double>& y) {
    const Json& layers = test.at("layers");
    Scene scene = column(soil(layers.at(0).at(0), flow_of(model)), triangle(test.at("q"), test.at("td")));
    scene.mesh.degree = 3;
    scene.regions = {{"rubble", soil(layers.at(0).at(0), flow_of(model))},
                     {"sand", soil(layers.at(1).at(0), flow_of(model))}};
    scene.fluid = fluid(layers.at(0).at(0));
    scene.probes["top"].at = {0.5, height};
    for (const double at : y)
      if (at <= sand_thickness) scene.probes[name_of(at)].at = {0.5, at};
    return scene;
  }

 public:
  static std::string name_of(double y) { return "y" + std::to_string(std::lround(1e6 * y)); }

 private:
  std::unique_ptr<Mesh> mesh_;
  Compiled compiled_;
  Response response_;
};

class Layered : public ::testing::TestWithParam<std::string> {};

TEST_P(Layered, BothSidesAreRight) {
  const Json test = stress_case('i'), exact = test.at("models").at(GetParam());
  const std::vector<double> t = test.at("t"), y = lines(0.02);
  const LayeredColumn coarse(test, GetParam(), y);
  std::vector<double> u = coarse.at("probes/top/displacement_y", t);
  for (double& value : u) value *= -1.;
  const auto p_interface = coarse.at("probes/" + LayeredColumn::name_of(sand_thickness) + "/pressure", t);
  const auto p_base = coarse.at("probes/y0/pressure", t);
  Record record("stress_layers");
  const std::string name = GetParam() + ": ";
  record.at_most(name + "u at the top over its largest value", largest_error(u, exact.at("u_top_down")), 1e-3);
  record.at_most(name + "p at the interface over its largest value",
                 largest_error(p_interface, exact.at("p_interface")), 1e-2);
  record.at_most(name + "p at the base over its largest value", largest_error(p_base, exact.at("p_base")), 1e-2);
  record.curve({GetParam() + ", u", "time (s)", "settlement (m)", "", t, exact.at("u_top_down"), u});
  record.curve({GetParam() + ", p", "time (s)", "p (Pa)", "interface", t, exact.at("p_interface"), p_interface});
  record.curve({GetParam() + ", p", "time (s)", "p (Pa)", "base", t, exact.at("p_base"), p_base});
}

TEST_P(Layered, PressureDoesNotOscillateInTheSand) {
  const Json test = stress_case('i');
  const std::vector<double> y = lines(0.02);
  std::vector<double> halved(y);
  for (std::size_t i = 1; i < y.size(); ++i) halved.push_back(0.5 * (y[i - 1] + y[i]));
  std::sort(halved.begin(), halved.end());
  const LayeredColumn coarse(test, GetParam(), y), fine(test, GetParam(), halved);
  std::vector<double> on_coarse, on_fine;
  for (const double at : y)
    if (at <= sand_thickness) {
      const std::string reading = "probes/" + LayeredColumn::name_of(at) + "/pressure";
      on_coarse.push_back(coarse.at(reading, {0.05})[0]);
      on_fine.push_back(fine.at(reading, {0.05})[0]);
    }
  ASSERT_GT(on_fine.size(), 30u);
  Record("stress_layers")
      .at_most(GetParam() + ": p at the sand's nodes at 0.05 s, against cells half as large, over its largest value",
               largest_error(on_coarse, on_fine), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Models, Layered, ::testing::Values("upB"));
INSTANTIATE_TEST_SUITE_P(ModelsAtLength, Layered, ::testing::Values("full"));

}  // namespace layered_column_test
}  // namespace upbead::test
