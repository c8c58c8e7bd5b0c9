// Claim: a rigid mass on the elastic half-plane or on a layer, swaying alone or with rocking, transmits the exact
// shear force to its base. One half is computed: the motion is antisymmetric.
// Source: tests/reference/ref4_strip.json, block `ft`: mass ratios m / (rho b^2) of 1, 2, 4 and 8, triangles of 10 to
// 400 ms; bonded contact.
// Limit: peak of F_T 0.5 %. The half-plane is 70 m deep and wide beside the caisson and marched until the first
// reflection arrives; the layer has 120 m beside the caisson.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "record.h"
#include "reference.h"
#include "strip_scene.h"

namespace upbead::test {
namespace elastic_strip_test {

constexpr double end_on_half_plane = 0.5;  // s: until a P wave (281 m/s) is back from 70 m

StripCells cells(bool half_plane) {
  StripCells cells;
  cells.edge = 0.05;
  cells.skin = half_plane ? 0.8 : 0.1;  // below the first 10 m of the half-plane
  cells.growth = half_plane ? 6. : 4.;
  cells.along = 3.;
  cells.near = 10.;
  cells.far = half_plane ? 3. : 8.;
  cells.width = half_plane ? 70. : 120.;
  return cells;
}

std::unique_ptr<StripModel> model_of(const Json& entry) {
  StripCaisson caisson{entry.at("b"), entry.at("m"), entry.at("IG"), entry.at("hG"), entry.at("hP")};
  if (entry.at("mode") == "sway") caisson.moment_of_inertia *= 1e12;  // so that it does not turn
  Region ground;
  ground.kind = RegionKind::solid;
  ground.density = entry.at("rho").get<double>();
  ground.poissons_ratio = entry.at("nu").get<double>();
  const double c_s = entry.at("cs"), rho = entry.at("rho");
  ground.shear_modulus = rho * c_s * c_s;
  std::vector<Layer> layers;
  if (entry.at("H").is_null())
    layers = {{"ground", 10., 0.003 * c_s, ground}, {"below", 60., 0.8, ground}};
  else
    layers = {{"ground", entry.at("H"), 0.003 * c_s, ground}};
  return std::make_unique<StripModel>(caisson, layers, Fluid{}, cells(entry.at("H").is_null()));
}

class ElasticStrip : public ::testing::TestWithParam<std::tuple<std::string, std::string, double>> {};

TEST_P(ElasticStrip, PassesTheForceOn) {
  const auto& [name, mode, ratio] = GetParam();
  const Json all = reference("ref4_strip");
  std::unique_ptr<StripModel> strip;
  Record record("elastic_strip");
  for (const Json& entry : all.at("ft")) {
    if (entry.at("case") != name || entry.at("mode") != mode || entry.at("mass_ratio_m_over_rho_b2") != ratio) continue;
    ASSERT_EQ(entry.at("kelvin_voigt_eta"), 0.);
    std::vector<double> t = entry.at("t"), exact = entry.at("FT");
    while (name == "half-plane" && t.back() > end_on_half_plane) t.pop_back();
    exact.resize(t.size());
    if (!strip) {
      strip = model_of(entry);
      strip->march_ramp(t.back(), 0.00125);
    }
    const double td = entry.at("td"), peak = entry.at("peak_FT");
    const StripHistory found = strip->under_triangle(td);
    const auto shear = sampled(found.time, found.shear, t);
    std::ostringstream what;
    what << name << ", " << mode << ", mass ratio " << ratio << ", " << 1e3 * td << " ms: ";
    record.at_most(what.str() + "peak of F_T, relative", std::abs(found.peak_shear / peak - 1.), 5e-3);
    record.measured(what.str() + "F_T over its peak", largest_error(shear, exact, peak));
    if (td == 0.1 && ratio == 4.) record.curve({name, "time (s)", "F_T / peak P", mode, t, exact, shear});
  }
  ASSERT_TRUE(strip) << "no such case";
}

INSTANTIATE_TEST_SUITE_P(Cases, ElasticStrip,
                         ::testing::Combine(::testing::Values("half-plane", "layer15m"),
                                            ::testing::Values("sway", "sway+rocking"),
                                            ::testing::Values(1., 2., 4., 8.)));

}  // namespace elastic_strip_test
}  // namespace upbead::test
