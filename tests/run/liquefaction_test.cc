// Claims: under a harmonic pressure of the sea on its top a layer has the excess pressure of the closed form, and
// with it the factor against momentary liquefaction, the depth down to which nothing is left, and their place; a march
// and a reduced model say the same; a surcharge adds to what resists; cells too large for the gradient under the
// surface are told; nothing is computed that was not asked for; of a breakwater each region has a place on both sides.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>

#include "findings/find.h"
#include "scenes.h"
#include "upbead/run/simulation.h"

namespace upbead::test {
namespace liquefaction_test {

constexpr double depth = 10., period = 4., p0 = 30e3;  // m, s, Pa
constexpr double pi_here = 3.14159265358979323846;

/// A wave that grows over three periods: its excess pressure is largest in the end, when it is harmonic.
TimeFunction growing_wave() {
  std::vector<double> time, value;
  for (int i = 0; i <= 64 * 6; ++i) {
    const double t = i * period / 64.;
    time.push_back(t);
    value.push_back(p0 * std::min(1., t / (3. * period)) * std::sin(2. * pi_here * t / period));
  }
  return piecewise_linear(time, value);
}

Scene layer() {
  Region soil = sand();
  soil.damping.reset();
  soil.hydraulic_conductivity = 1e-4;
  Scene scene = column(soil, growing_wave());
  scene.loads["top"].kind = LoadKind::pressure;
  scene.loads["top"].direction = {1., 0.};
  scene.fluid.bulk_modulus = 2e7;  // air in the water
  scene.time.end = 6. * period;
  scene.time.inertia = false;
  scene.time.scheme = TimeScheme::sdirk4;
  scene.time.step = period / 64.;
  scene.initial.emplace().water_level = 2. * depth;
  scene.limits.liquefaction = 1.;
  scene.probes["middle"].at = {0.5, 0.7 * depth};
  return scene;
}

/// Amplitude of p - p_top at depth z of a layer on a sealed rigid base, without inertia: with c p'' = p' - g p_top'
///   p = p_top (g + (1 - g) cosh(k (D - z))/cosh(k D)),  k^2 = i omega/c,
/// g = (1/M)/(n/K_f + 1/M), c = (K/gamma_w)/(n/K_f + 1/M), M = 2 G (1 - nu)/(1 - 2 nu): Biot's
/// equations in one dimension with sigma' = p - p_top and incompressible grains, derived here.
double amplitude(const Scene& scene, double z) {
  const Region& soil = scene.regions.at("soil");
  const double G = *soil.shear_modulus, nu = *soil.poissons_ratio, M = 2. * G * (1. - nu) / (1. - 2. * nu);
  const double storage = *soil.porosity / scene.fluid.bulk_modulus + 1. / M, g = 1. / M / storage;
  const double weight = scene.fluid.density * scene.gravity;
  const std::complex<double> k =
      std::sqrt(std::complex<double>(0., 2. * pi_here / period * storage * weight / *soil.hydraulic_conductivity));
  return p0 * (1. - g) * std::abs(1. - std::cosh(k * (depth - z)) / std::cosh(k * depth));
}

double submerged(const Scene& scene) {
  const Region& soil = scene.regions.at("soil");
  return (1. - *soil.porosity) * (*soil.grain_density - scene.fluid.density) * scene.gravity;
}

Summary summary_of(const Scene& scene, int cells = 120, double grading = 40.) {
  return Simulation(scene, column_mesh(depth, cells, grading)).run().summary;
}

bool is_warned(const Summary& summary, const std::string& name) {
  for (const NumberedWarning& w : summary.warnings)
    if (w.name == name) return true;
  return false;
}

/// The deepest z at which the amplitude still is the stress.
double exact_depth(const Scene& scene) {
  double z = depth;
  while (z > 0. && amplitude(scene, z) < submerged(scene) * z) z -= 1e-4;
  return z;
}

TEST(Liquefaction, OfALayerIsThatOfTheClosedForm) {
  const Scene scene = layer();
  const Summary s = summary_of(scene);
  ASSERT_TRUE(s.liquefaction && s.liquefaction->factor);
  ASSERT_EQ(s.liquefaction->places.size(), 1u);
  const LiquefiedPlace& place = s.liquefaction->places[0];
  EXPECT_EQ(place.region, "soil");
  EXPECT_EQ(place.side, "");
  const double exact = submerged(scene) * place.below / amplitude(scene, place.below);
  EXPECT_NEAR(*place.factor, exact, 0.01 * exact);
  EXPECT_NEAR(place.pressure, amplitude(scene, place.below), 0.01 * amplitude(scene, place.below));
  EXPECT_NEAR(place.stress, submerged(scene) * place.below, 1e-6 * place.stress);
  EXPECT_NEAR(place.at[1], depth - place.below, 1e-9);
  ASSERT_LT(exact, 1.) << "the wave liquefies some depth";
  // verticals have points at depths of 10 m (k/48)^2
  EXPECT_NEAR(place.depth, exact_depth(scene), 2. * std::sqrt(depth * place.depth) / 48.);
  ASSERT_TRUE(place.depth_time);
  EXPECT_GT(*place.depth_time, 2.5 * period);
  EXPECT_TRUE(is_warned(s, "momentary_liquefaction"));
  EXPECT_FALSE(is_warned(s, "liquefaction_cells"));
}

TEST(Liquefaction, IsResistedByASurcharge) {
  Scene scene = layer();
  const Summary bare = summary_of(scene, 40, 20.);
  scene.initial->surcharge["armour"] = {"top", 5e3, {}, {}};
  const Summary s = summary_of(scene, 40, 20.);
  const LiquefiedPlace &with = s.liquefaction->places[0], &without = bare.liquefaction->places[0];
  EXPECT_NEAR(with.stress, 5e3 + submerged(scene) * with.below, 1e-6 * with.stress);
  EXPECT_GT(*with.factor, *without.factor);
}

TEST(Liquefaction, TellsOfCellsThatDoNotSeeTheGradient) {
  EXPECT_TRUE(is_warned(summary_of(layer(), 5, 1.), "liquefaction_cells"));
}

TEST(Liquefaction, IsNotComputedUnlessAskedFor) {
  Scene scene = layer();
  scene.limits.liquefaction.reset();
  const Summary s = summary_of(scene, 10, 1.);
  EXPECT_FALSE(s.liquefaction);
  EXPECT_EQ(s.why_no_liquefaction, "");
}

Summary of_breakwater(TimeScheme scheme) {
  Scene scene = breakwater(triangle(5e5, 0.3));
  scene.initial.emplace().water_level = 15.;
  scene.limits.liquefaction = 1.;
  scene.time.end = 0.6;
  scene.time.scheme = scheme;
  return Simulation(scene, breakwater_mesh(0.5)).run().summary;
}

TEST(Liquefaction, IsTheSameByAMarch) {
  const Summary reduced = of_breakwater(TimeScheme::reduced), marched = of_breakwater(TimeScheme::sdirk4);
  ASSERT_TRUE(reduced.liquefaction && marched.liquefaction);
  EXPECT_NEAR(*marched.liquefaction->factor, *reduced.liquefaction->factor, 0.02 * *reduced.liquefaction->factor);
}

TEST(Liquefaction, OfABreakwaterHasPlacesOnBothSides) {
  const Summary s = of_breakwater(TimeScheme::reduced);
  ASSERT_TRUE(s.liquefaction && s.liquefaction->factor);
  std::set<std::pair<std::string, std::string>> names;
  for (const LiquefiedPlace& place : s.liquefaction->places) {
    names.emplace(place.region, place.side);
    if (!place.factor) continue;
    EXPECT_GE(*place.factor, *s.liquefaction->factor);
    EXPECT_NEAR(place.stress / place.pressure, *place.factor, 1e-9 * *place.factor);
    EXPECT_EQ(place.side, place.at[0] < 0. ? "sea" : "harbour");
    EXPECT_GT(std::abs(place.at[0]), 9.) << "beside the caisson, not under it";
  }
  for (const char* region : {"mound", "seabed"})
    for (const char* side : {"sea", "harbour"}) EXPECT_EQ(names.count({region, side}), 1u) << region << side;
}

/// What a wave on the wall alone does to the ground beside it fails rightly, and holds nothing.
TEST(Liquefaction, OfAWaveOnTheWallAloneHoldsNothing) {
  const Summary s = of_breakwater(TimeScheme::reduced);
  const double factor = *s.liquefaction->factor;
  const auto judged = [&](double limit, LoadKind kind) {
    Scene scene;
    scene.limits.liquefaction = limit;
    scene.loads["sea"].kind = kind;
    for (const Check& one : checks_of(scene, s))
      if (one.name == "momentary liquefaction") {
        EXPECT_NEAR(one.balance->resisting / one.balance->acting, factor, 1e-9 * factor);
        return one.holds;
      }
    return std::optional<bool>();
  };
  EXPECT_EQ(judged(0.9 * factor, LoadKind::force), std::nullopt);
  EXPECT_EQ(judged(1.1 * factor, LoadKind::force), false);
  EXPECT_EQ(judged(0.9 * factor, LoadKind::pressure), true);
}

}  // namespace liquefaction_test
}  // namespace upbead::test
