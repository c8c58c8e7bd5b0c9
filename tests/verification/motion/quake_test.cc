// Claim: under an earthquake F_T is the caisson's inertia force: on rigid ground F_T = -m a(t); on ground that
// deforms both routes to F_T agree and the balance of energy closes, with and without damping, sea and slip.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/compile.h"
#include "layer.h"
#include "record.h"
#include "reference.h"
#include "scenes.h"
#include "upbead/run/simulation.h"

namespace upbead::test {
namespace quake_test {

const double pi = std::acos(-1.);

/// Velocity of a base that is accelerated by a sin(2 pi t/T) for one period.
TimeFunction shock(double a, double T) {
  const auto zero = [](double) { return 0.; };
  const auto wave = [a, T](double t) { return a * T / (2. * pi) * (1. - std::cos(2. * pi * t / T)); };
  return TimeFunction({0., T}, {zero, wave, zero});
}

Scene shaken(double a, double T) {
  Scene scene = breakwater({});
  scene.loads.clear();
  Load load;
  load.boundary = "base";
  load.kind = LoadKind::acceleration;
  load.history = shock(a, T);
  load.duration = 0.5 * T;
  scene.loads["quake"] = load;
  for (const char* side : {"left", "right"}) scene.boundaries[side].displacement = DisplacementCondition::level;
  scene.time.end = 2. * T;
  return scene;
}

TEST(CaissonUnderAnEarthquake, FeelsItsInertiaOnStiffGround) {
  constexpr double v = 0.1, T = 0.5;  // smooth, as a kink of a(t) would excite vibrations of the stiff ground
  Scene scene = shaken(1., T);
  scene.loads["quake"].history = smooth_velocity(v, T);
  scene.loads["quake"].duration = 0.25 * T;
  for (const char* soil : {"seabed", "mound"}) {
    scene.regions[soil].flow = Flow::drained;
    *scene.regions[soil].shear_modulus *= 1e4;
  }
  const std::shared_ptr<const Mesh> mesh = breakwater_mesh(0.35);
  const auto run = Simulation(scene, mesh).run({});
  const Compiled compiled(scene, *mesh);
  const auto found = history(compiled, run.response, "shear_force");
  const double m = compiled.scene.caisson->body.mass;
  std::vector<double> exact;
  for (const double t : run.response.ends.time) {
    const double sine = std::sin(pi * t / T);
    exact.push_back(t < T ? -m * 4. * v * pi / T * std::pow(sine, 3) * std::cos(pi * t / T) : 0.);
  }
  Record record("quake");
  record.at_most("stiff ground: F_T against -m a, over the largest",
                 largest_error(sampled(run.response.ends.time, found, run.response.ends.time), exact), 1e-3);
}

struct Ground {
  std::string name;
  bool damped, sea, slips;
  DisplacementCondition base;
};

class Quake : public ::testing::TestWithParam<Ground> {};

TEST_P(Quake, BalancesForcesAndEnergy) {
  const Ground& ground = GetParam();
  Scene scene = shaken(6., 0.4);
  scene.time.end = 0.6;
  scene.boundaries["base"].displacement = ground.base;
  if (ground.sea) add_sea(scene);
  for (const char* soil : {"seabed", "mound"})
    if (!ground.damped) scene.regions[soil].damping.reset();
  if (ground.slips) {
    scene.regions["caisson"].interface = ContactLaw{ContactKind::friction, 0.5};
    scene.initial = InitialState{15., {}};
  }
  const std::shared_ptr<const Mesh> mesh =
      breakwater_mesh(0.25, ground.sea ? with_sea() : std::map<std::string, double>());
  const auto run = Simulation(scene, mesh).run({});
  const Summary& summary = run.summary;
  Record record("quake");
  ASSERT_TRUE(summary.response && summary.energy);
  EXPECT_GT(std::abs(summary.response->peak_shear_seaward) + std::abs(summary.response->peak_shear), 1e5);
  record.at_most(ground.name + ": both routes to F_T, over its peak", summary.response->reaction_mismatch, 1e-8);
  record.at_most(ground.name + ": energy", summary.energy->mismatch(), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(
    Grounds, Quake,
    ::testing::Values(Ground{"base shaken, damped", true, false, false, DisplacementCondition::fixed},
                      Ground{"base shaken, undamped, sea", false, true, false, DisplacementCondition::fixed},
                      Ground{"base shaken, damped, sea, friction node by node", true, true, true,
                             DisplacementCondition::fixed},
                      Ground{"waves from below, damped, sea", true, true, false, DisplacementCondition::absorbing}));

}  // namespace quake_test
}  // namespace upbead::test
