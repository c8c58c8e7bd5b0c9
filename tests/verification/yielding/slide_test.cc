// Claim: a block on a thin layer of stiff soil with phi = 0 slides as a rigid block on cohesive friction F = s_u B, m
// x'' = P - F, and comes to rest at the place of the exact motion, under steep and slow pulses. The effect of the
// layer's elasticity, 2.5e-3 of the steep slide and proportional to 1/G, is that of an elastic, perfectly plastic
// spring G B / h. tests/run/yielding_run_test.cc has the same block as a case, under a symmetric pulse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "material/mohr_coulomb_law.h"
#include "tensor_mesh.h"
#include "yielding_march.h"

namespace upbead::test {
namespace slide_test {

constexpr double B = 400., h = 1., mass = 4e6, G = 1e10;

struct Pulse {
  const char* name;
  double peak, duration, rise, strength, end;  // N/m, s, s, Pa, s
};

/// The exact slide: P is linear by parts, so that x is of degree 3 between its corners, start and rest.
double exact_slide(const Pulse& pulse) {
  const double F = B * pulse.strength, fall = pulse.duration - pulse.rise;
  const double start = pulse.rise * F / pulse.peak, up = pulse.rise - start;  // P - F grows from 0 to peak - F
  const double rate = pulse.peak / pulse.rise / mass, most = (pulse.peak - F) / mass;
  double v = 0.5 * rate * up * up, x = rate * up * up * up / 6.;
  const double down = pulse.peak / fall / mass;
  // v(t) = v + most t - down t^2/2 while P falls to zero; then -F/m alone
  const double rest = (most + std::sqrt(most * most + 2. * down * v)) / down;
  const double t = std::min(rest, fall);
  x += v * t + 0.5 * most * t * t - down * t * t * t / 6.;
  if (rest <= fall) return x;
  v += most * t - 0.5 * down * t * t;
  return x + 0.5 * v * v * mass / F;
}

/// Final position of a block on an elastic, perfectly plastic spring, by explicit steps; after its last slip it
/// oscillates about its position of rest.
double slide_on_spring(const Pulse& pulse) {
  const TimeFunction P = triangle(pulse.peak, pulse.duration, pulse.rise);
  constexpr double step = 2e-6, k = G * B / h;
  double x = 0., v = 0., slid = 0.;
  for (double t = 0.; t < pulse.end; t += step) {
    const double trial = k * (x - slid), F = std::clamp(trial, -B * pulse.strength, B * pulse.strength);
    slid += (trial - F) / k;
    v += step * (P(t) - F) / mass;
    x += step * v;
  }
  return x;
}

std::unique_ptr<Mesh> layer_and_block() {
  const auto surface = [](const dealii::Point<dim>& p) { return p[1] < h ? "soil" : "caisson"; };
  const auto curve = [](const dealii::Point<dim>& p) -> std::string {
    if (p[1] < 1e-9) return "base";
    if (p[1] > h + 1e-9) return "walls";
    return std::abs(p[0]) > 0.5 * B - 1e-9 ? "sides" : "";
  };
  return tensor_mesh(even_lines(-0.5 * B, 0.5 * B, 40), {0., h, 3.}, surface, curve);
}

Scene block_on_layer(const Pulse& pulse) {
  Scene scene;
  Region soil, block;
  soil.kind = RegionKind::solid;
  soil.deformation = Deformation::elastic;
  // the layer has 1/5000 of the block's mass; without mass, flowing soil would have no stiffness at all
  soil.density = 2.;
  soil.poissons_ratio = 0.3;
  soil.shear_modulus = G;
  soil.law = SoilLaw::mohr_coulomb;
  soil.strength = Strength{0., pulse.strength, 0., 0.};
  block.kind = RegionKind::rigid;
  block.mass = mass;
  scene.regions = {{"soil", soil}, {"caisson", block}};
  scene.boundaries["base"] = {DisplacementCondition::fixed, {}};
  scene.boundaries["sides"] = scene.boundaries["walls"] = {};
  Load load;
  load.region = caisson_name;
  load.at = {0., h};
  load.history = triangle(pulse.peak, pulse.duration, pulse.rise);
  scene.loads["impact"] = load;
  return scene;
}

void compare_with_exact(const Pulse& pulse) {
  Record record("yielding_slide");
  const auto mesh = layer_and_block();
  const Scene scene = block_on_layer(pulse);
  const auto law =
      std::make_shared<const MohrCoulombLaw>(elastic_law(G, 0.3), MohrCoulombStrength{0., pulse.strength, 0., 1e6});
  // under compression, so that it does not part
  const SoilPoints pressed = [points = mohr_coulomb_points(law, {{-98e3, -98e3, 0., -98e3}})](unsigned, unsigned q) {
    return points(q);
  };
  const double rigid = exact_slide(pulse), spring = slide_on_spring(pulse);
  const YieldingMarch found(scene, *mesh, pulse.end, pulse.duration / 400., pressed, 1e-6);
  const double moved = found.history("caisson/displacement_x").tail(1)[0], F = B * pulse.strength;
  const std::string what = std::string(pulse.name) + ": ";
  record.at_most(what + "residual displacement of the block, relative", std::abs(moved / rigid - 1.), 5e-3);
  record.at_most(what + "the same against a block on an elastic, perfectly plastic spring",
                 std::abs(moved / spring - 1.), 1e-3);
  record.at_most(what + "largest F_T over s_u B, less 1", std::abs(found.history("shear_force").maxCoeff() / F - 1.),
                 5e-3);
  record.at_most(what + "energy taken by the soil over s_u B x, less 1",
                 std::abs(found.energy().plastic / (F * rigid) - 1.), 0.01);
}

TEST(RigidPlasticLayer, UnderASlowPulseABlockSlidesAsFarAsItIsExactAtLength) {
  compare_with_exact({"slow, P / F = 1.25", 2.5e6, 1.0, 0.3, 5e3, 1.0});
}

TEST(RigidPlasticLayer, UnderASteepPulseABlockSlidesAsFarAsItIsExactAtLength) {
  compare_with_exact({"steep, P / F = 5", 1e7, 0.2, 0.02, 5e3, 0.6});
}

}  // namespace slide_test
}  // namespace upbead::test
