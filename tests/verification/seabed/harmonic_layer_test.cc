// Claim: a saturated layer under a harmonic load on its drained top has the complex amplitudes of pressure and
// settlement of Zienkiewicz, Chang and Bettess (1980), at 25 points of their map (Pi1, Pi2), by the frequency
// response of the same M, C and K as in a march, for full Biot equations, Darcy flow, consolidation without inertia,
// and undrained soil.
// Source: tests/reference/ref2c_zcb_map.json (exponentials, exact; 7 digits).
// Limit: 0.5 % of each amplitude.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "frequency_response.h"
#include "record.h"
#include "reference.h"
#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace harmonic_layer_test {

/// A model of the table, and the settings of the scene for it.
struct Model {
  std::string name, title;
  Flow flow = Flow::darcy;
  bool inertia = true, drains = true;
};

const std::vector<Model> models{{"full", "full Biot equations", Flow::inertial, true, true},
                                {"upB", "Darcy flow", Flow::darcy, true, true},
                                {"cons", "consolidation without inertia", Flow::darcy, false, true},
                                {"undr", "undrained (k -> 0, sealed top)", Flow::darcy, true, false}};

/// Heights of the table, over L.
const std::vector<double> heights{0., 0.25, 0.5, 0.75, 1.};

Scene layer(const Json& input, const Model& model) {
  const double n = input.at("n"), rho_f = input.at("rho_f"), gravity = 9.81;
  Region region;
  region.shear_modulus = input.at("D").get<double>() / 3.;  // D = lambda + 2 G = 3 G at nu = 1/4
  region.poissons_ratio = 0.25;
  region.porosity = n;
  region.grain_density = (input.at("rho").get<double>() - n * rho_f) / (1. - n);
  region.hydraulic_conductivity = (model.drains ? input.at("kappa").get<double>() : 1e-9) * rho_f * gravity;
  region.flow = model.flow;
  Scene scene = column(region, triangle(input.at("q"), 1.));  // any history: the response is to unit amplitude
  scene.gravity = gravity;
  scene.fluid = {rho_f, input.at("Kf_over_n").get<double>() * n};
  scene.time.inertia = model.inertia;
  if (!model.drains) scene.boundaries["top"].pressure = PressureCondition::sealed;
  for (std::size_t i = 0; i < heights.size(); ++i)
    scene.probes["x" + std::to_string(i)].at = {0.005, heights[i] * input.at("L").get<double>()};
  return scene;
}

/// A row of 508 cells, small at the top for the drained skin (thickness sqrt(2 c_v / omega) = 0.023 L at the least).
/// The other cells are set by Pi2 = 10: there the wave of the drained skeleton, 0.35 L long, is close to resonance,
/// which magnifies an error of its length; the error falls with the square of the size of the cells.
std::unique_ptr<Mesh> layer_mesh() {
  const auto curve = [](const dealii::Point<dim>& at) -> std::string {
    if (at[1] < 1e-9) return "base";
    if (at[1] > 1. - 1e-9) return "top";
    return at[0] < 1e-9 ? "left" : at[0] > 0.01 - 1e-9 ? "right" : "";
  };
  return tensor_mesh(
      {0., 0.01}, graded_lines(1., 0., 0.0005, 1.1, 0.002), [](const auto&) { return "soil"; }, curve);
}

struct Amplitudes {
  std::vector<Complex> p;
  Complex u_top;
};

Amplitudes computed(const Mesh& mesh, const Json& input, const Model& model) {
  const Compiled compiled(layer(input, model), mesh);
  const System& system = compiled.system;
  const FrequencyResponse response(system, input.at("omega"));
  const std::vector<Complex> load{input.at("q").get<double>()};
  const ComplexVector x = response(load);
  const auto read = [&](std::size_t i, const char* quantity) {
    const auto name = "probes/x" + std::to_string(i) + "/" + quantity;
    return response.read(system.readings[static_cast<std::size_t>(system.reading(name))], x, load);
  };
  Amplitudes found;
  for (std::size_t i = 0; i < heights.size(); ++i) found.p.push_back(read(i, "pressure"));
  found.u_top = read(heights.size() - 1, "displacement_y");
  return found;
}

Amplitudes exact(const Json& table) {
  Amplitudes found;
  for (std::size_t i = 0; i < heights.size(); ++i)
    found.p.push_back(std::polar(table.at("abs_p").at(i).get<double>(), table.at("arg_p").at(i).get<double>()));
  found.u_top = {table.at("u_top").at("re").get<double>(), table.at("u_top").at("im").get<double>()};
  return found;
}

/// Largest difference of two amplitudes, phases included, over the exact one; p = 0 on a drained top is left out.
double largest_relative_error(const std::vector<Complex>& found, const std::vector<Complex>& table) {
  std::vector<double> relative;
  for (std::size_t i = 0; i < table.size(); ++i)
    if (std::abs(table[i]) > 1e-12) relative.push_back(std::abs(found[i] - table[i]) / std::abs(table[i]));
  return largest_error(relative, std::vector<double>(relative.size(), 0.), 1.);
}

/// |p| over the height at some points of the map, for a figure.
void draw(Record& record, const Json& point, const std::vector<Complex>& found, const std::vector<Complex>& table) {
  const double Pi1 = point.at("Pi1"), Pi2 = point.at("Pi2");
  if (Pi2 < 1. || Pi1 < 0.1 || Pi1 > 10.) return;
  Curve curve{
      Pi2 == 1. ? "harmonic layer, full Biot equations, Pi2 = 1" : "harmonic layer, full Biot equations, Pi2 = 10",
      "height / layer",
      "|p| / load",
      Pi1 == 0.1  ? "Pi1 = 0.1"
      : Pi1 == 1. ? "Pi1 = 1"
                  : "Pi1 = 10",
      heights,
      {},
      {}};
  for (std::size_t i = 0; i < heights.size(); ++i) {
    curve.exact.push_back(std::abs(table[i]));
    curve.computed.push_back(std::abs(found[i]));
  }
  record.curve(curve);
}

TEST(HarmonicLayer, AmplitudesAt25PointsOfTheMap) {
  Record record("harmonic_layer");
  const auto mesh = layer_mesh();
  const Json all = reference("ref2c_zcb_map");
  const Json& points = all.at("profile_points");
  ASSERT_EQ(points.size(), 25u);
  for (const Model& model : models) {
    double pressure = 0., settlement = 0.;
    for (const Json& point : points) {
      const Amplitudes found = computed(*mesh, point.at("dimensionless_input"), model);
      const Amplitudes table = exact(point.at(model.name));
      pressure = std::max(pressure, largest_relative_error(found.p, table.p));
      settlement = std::max(settlement, largest_relative_error({found.u_top}, {table.u_top}));
      if (model.name == "full") draw(record, point, found.p, table.p);
    }
    record.at_most(
        "25 points, " + model.title + ": complex pressure at five heights, each relative to its own amplitude",
        pressure, 5e-3);
    record.at_most("25 points, " + model.title + ": complex settlement of the top, relative to its amplitude",
                   settlement, 5e-3);
  }
}

}  // namespace harmonic_layer_test
}  // namespace upbead::test
