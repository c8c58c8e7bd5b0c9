// Claim: a poroelastic column of soil under a triangular pulse moves and builds pore pressure as the exact solution
// says, with inertial flow in rubble and darcy flow in sand.
// Source: tests/reference/ref2b_column.json (Schanz and Cheng 2000; Laplace transform inverted numerically), models
// `full` and `upB`. The sand's mesh is graded towards the top, where a skin of some centimetres drains. Limits: u_top
// 0.1 % and p_base 1 % of their largest value.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "scenes.h"

namespace upbead::test {
namespace {

using Json = nlohmann::json;

Json reference(const std::string& name, double duration) {
  std::ifstream file(std::string(UPBEAD_REFERENCE_DIR) + "/ref2b_column.json");
  const Json all = Json::parse(file);
  for (const Json& entry : all.at("cases"))
    if (entry.at("name") == name && entry.at("load").at("kind") == "tri" && entry.at("load").at("td") == duration)
      return entry;
  throw std::runtime_error("no such reference");
}

Region soil(const Json& entry, Flow flow) {
  const Json& m = entry.at("material_input");
  Region region;
  region.kind = RegionKind::porous;
  region.youngs_modulus = m.at("Ey").get<double>();
  region.poissons_ratio = m.at("nu").get<double>();
  region.porosity = m.at("n").get<double>();
  region.grain_density = m.at("rho_s").get<double>();
  region.hydraulic_conductivity = m.at("k").get<double>();
  region.tortuosity = m.at("a_inf").get<double>();
  region.flow = flow;
  return region;
}

/// Largest difference to the reference over its times, relative to the reference's largest value.
double error(const std::vector<double>& times, const Eigen::RowVectorXd& values, const Json& t, const Json& exact,
             double largest) {
  double worst = 0.;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double at = t[i].get<double>();
    const auto above = std::upper_bound(times.begin(), times.end(), at) - times.begin();
    const auto k = static_cast<std::size_t>(above);
    const double weight = (at - times[k - 1]) / (times[k] - times[k - 1]);
    const double value = (1. - weight) * values[above - 1] + weight * values[above];
    worst = std::max(worst, std::abs(value - exact[i].get<double>()));
  }
  return worst / largest;
}

void compare(const std::string& name, double duration, Flow flow, const std::string& model, int cells, double grading) {
  const Json entry = reference(name, duration);
  const double height = entry.at("L"), q = entry.at("q");
  Scene scene = column(soil(entry, flow), triangle(q, duration));
  if (entry.at("where") == "water") {
    scene.loads["top"].kind = LoadKind::pressure;  // on a pervious surface: total stress and pore pressure
    scene.loads["top"].direction = {1., 0.};
  }
  scene.fluid = {entry.at("material_input").at("rho_f"), entry.at("material_input").at("Kf")};
  scene.probes["top"].at = {0.5, height};
  scene.probes["base"].at = {0.5, 0.};
  const auto mesh = column_mesh(height, cells, grading);
  const Compiled compiled(scene, *mesh);
  const double end = entry.at("t").back().get<double>() * 1.01;
  const Response response = run(compiled, end, duration / 400.);
  const Json& exact = entry.at("models").at(model);
  EXPECT_LE(error(response.ends.time, history(compiled, response, "probes/top/displacement_y"), entry.at("t"),
                  exact.at("u_top"), exact.at("max_abs_u_top")),
            1e-3);
  EXPECT_LE(error(response.ends.time, history(compiled, response, "probes/base/pressure"), entry.at("t"),
                  exact.at("p_base"), exact.at("max_p_base")),
            1e-2);
}

TEST(Column, RubbleWithInertialFlow) {
  compare("rubble_L5_k0.1", 0.1, Flow::inertial, "full", 64, 1.);
}

TEST(Column, PressureOfWaterOnAPerviousTop) {
  compare("rubble_L5_k0.1_waterload", 0.1, Flow::inertial, "full", 64, 1.);
}

TEST(Column, SandWithDarcyFlow) {
  compare("sand_L15_k1e-05", 0.1, Flow::darcy, "upB", 96, 100.);
}

}  // namespace
}  // namespace upbead::test
