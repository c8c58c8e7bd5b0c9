// Claim: the account of energy of ground that is shaken as a whole is that of an observer at rest. Work is that of the
// base's reaction on its velocity, so of ground that only translates m v^2/2 and nothing is damped; damping, and waves
// that leave through an absorbing base, are those of the motion relative to the base, which is that under the body
// force -rho a above a base at rest (Chopra, Dynamics of structures (2012), section 9.4). Limits: round-off where
// steps are the same; 1e-6, of fourth order in the step, where the frame is accelerated by its velocity; 1e-3 where the
// ground still swings.
#include <gtest/gtest.h>

#include <cmath>

#include "layer.h"

namespace upbead::test {
namespace frame_energy_test {

constexpr double soil_density = 2000.;
const double pi = std::acos(-1.);

TimeFunction ramp(double v, double rise) {
  return TimeFunction({0., rise},
                      {[](double) { return 0.; }, [=](double t) { return v * t / rise; }, [=](double) { return v; }});
}

EnergyAccount end_of(const Scene& scene, const Mesh& mesh, double end, SchemeKind scheme = SchemeKind::sdirk4,
                     double step = 0.005) {
  const Compiled layer(scene, mesh);
  const Response response = run(layer, end, step, scheme);
  double mismatch = 0.;
  for (const EnergyAccount& energy : response.energy) mismatch = std::max(mismatch, energy.mismatch());
  EXPECT_LT(mismatch, 1e-7);  // ground that has moved by 11 m: round-off of K x
  return response.energy.back();
}

Shaking damped(bool vertical, DisplacementCondition base = DisplacementCondition::fixed) {
  Shaking shaking;
  shaking.vertical = vertical;
  shaking.base = base;
  shaking.damping = Rayleigh{0.05, {1., 10.}};
  return shaking;
}

TEST(EnergyOfShakenGround, ThatTranslatesIsKinetic) {
  constexpr double v = 1., kinetic = 0.5 * soil_density * layer_height * v * v;
  for (const bool vertical : {false, true})
    for (const SchemeKind scheme : {SchemeKind::sdirk4, SchemeKind::generalised_alpha})
      for (const auto base : {DisplacementCondition::fixed, DisplacementCondition::absorbing}) {
        const Shaking shaking = damped(vertical, base);
        const EnergyAccount energy = end_of(shaken_layer(shaking, ramp(v, 2.)), *layer_mesh(shaking, 4), 12., scheme);
        EXPECT_NEAR(energy.kinetic, kinetic, 1e-3 * kinetic);
        // the ground follows the ramp with a lag: what it takes meanwhile is small, and exact below
        EXPECT_NEAR(energy.work, kinetic, 0.1 * kinetic);
        EXPECT_LT(energy.damping + energy.radiated, 0.1 * kinetic);
        EXPECT_GE(energy.damping, 0.);
      }
}

/// The same relative motion: sheared by its own inertia above a base at rest.
TEST(EnergyOfShakenGround, IsDampedRelativeToTheBase) {
  constexpr double v = 0.5, T = 0.8;
  const auto zero = [](double) { return 0.; };
  const auto acceleration = [=](double t) {
    return v * 4. * pi / T * std::pow(std::sin(pi * t / T), 3) * std::cos(pi * t / T);
  };
  for (const bool vertical : {false, true})
    for (const auto base : {DisplacementCondition::fixed, DisplacementCondition::absorbing}) {
      const Shaking shaking = damped(vertical, base);
      const Scene moved = shaken_layer(shaking, smooth_velocity(v, T));
      Scene still = moved;
      Load& inertia = still.loads["shaking"];
      inertia.boundary = "";
      inertia.region = "soil";
      inertia.kind = LoadKind::body_force;
      inertia.history = TimeFunction({0., T}, {zero, [=](double t) { return -soil_density * acceleration(t); }, zero});
      const auto mesh = layer_mesh(shaking, 8);
      const EnergyAccount a = end_of(moved, *mesh, 1.2, SchemeKind::sdirk4, 0.002),
                          b = end_of(still, *mesh, 1.2, SchemeKind::sdirk4, 0.002);
      EXPECT_NEAR(a.damping, b.damping, 1e-6 * b.damping);
      EXPECT_NEAR(a.radiated, b.radiated, 1e-6 * b.radiated);
      EXPECT_NEAR(a.strain, b.strain, 1e-6 * b.largest_work);
      EXPECT_GT(b.damping, 0.);
      EXPECT_EQ(b.radiated > 0., base == DisplacementCondition::absorbing);
    }
}

/// Two motions of one base at once: what the frame does is quadratic in their sum.
TEST(EnergyOfShakenGround, AddsMotionsBeforeItSquaresThem) {
  for (const auto base : {DisplacementCondition::fixed, DisplacementCondition::absorbing}) {
    const Shaking shaking = damped(false, base);
    const auto mesh = layer_mesh(shaking, 4);
    Scene halves = shaken_layer(shaking, smooth_velocity(0.25, 0.8));
    halves.loads["more"] = halves.loads["shaking"];
    const EnergyAccount whole = end_of(shaken_layer(shaking, smooth_velocity(0.5, 0.8)), *mesh, 1.),
                        both = end_of(halves, *mesh, 1.);
    EXPECT_NEAR(both.work, whole.work, 1e-9 * whole.largest_work);
    EXPECT_NEAR(both.damping, whole.damping, 1e-9 * whole.damping);
    EXPECT_NEAR(both.radiated, whole.radiated, 1e-9 * whole.radiated);
  }
}

}  // namespace frame_energy_test
}  // namespace upbead::test
