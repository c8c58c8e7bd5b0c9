// Claims: work of the loads and reactions = energy stored + energy taken by drag and damping + energy taken by the
// scheme, for both schemes, any system, jumps, prescribed unknowns and step changes; each term is right by itself.
// Source: the schemes' energy identities (Burrage & Butcher 1979 for Runge-Kutta). Tolerance 1e-12 of the work: 200
// steps of sums of some hundred terms in double precision.
#include "upbead/dynamics/energy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_system.h"

namespace energy_test {

using namespace upbead;
using namespace upbead::test;

const SchemeOptions sdirk4{SchemeKind::sdirk4};
const SchemeOptions alpha{SchemeKind::generalised_alpha};

TimeFunction constant() {
  return TimeFunction({0.}, {[](double) { return 0.; }, [](double) { return 1.; }});
}

TEST(Energy, IsAccountedForInEverySystem) {
  for (const SchemeOptions& options : {sdirk4, alpha})
    for (double storage : {1., 0.})
      for (int prescribed = 0; prescribed < 3; ++prescribed) {
        Sample sample;
        sample.storage = storage;
        sample.prescribed_u = prescribed == 1;
        sample.prescribed_phi = prescribed == 2;
        System system = sample_system(sample);
        system.loads = {sample_load(system, jump())};
        if (prescribed > 0) system.loads.push_back(prescribed_load(system, smooth()));
        const auto scheme = make_scheme(system, options);
        const TimeGrid grid = make_time_grid({1., 2.3711, 5.}, 10., 0.05);
        double largest = 0.;
        for (const EnergyAccount& energy : march(system, *scheme, grid).energy)
          largest = std::max(largest, energy.mismatch());
        EXPECT_LT(largest, 1e-12) << scheme->name() << ", storage " << storage << ", prescribed " << prescribed;
        EXPECT_GT(scheme->energy().drag, 0.);
        EXPECT_GT(scheme->energy().damping, 0.);
        EXPECT_GT(scheme->energy().fluid, storage > 0. ? 0. : -1e-30);
        EXPECT_LT(std::abs(scheme->energy().scheme), 1e-2 * scheme->energy().largest_work);
      }
}

// A mass on spring and dashpot under a constant force comes to rest: the work of the force is f^2/k, of which the
// spring stores one half and the dashpot takes the other. 1e-9: the motion left after 40 decay times.
TEST(Energy, OfADampedOscillatorEndsHalfAndHalf) {
  const System system = oscillator(2., 1., 8., constant());
  for (const SchemeOptions& options : {sdirk4, alpha}) {
    const auto scheme = make_scheme(system, options);
    march(system, *scheme, make_time_grid({}, 160., 0.01));
    const EnergyAccount& energy = scheme->energy();
    EXPECT_NEAR(energy.work, 1. / 8., 1e-9);
    EXPECT_NEAR(energy.strain, 1. / 16., 1e-9);
    EXPECT_NEAR(energy.damping + energy.scheme, 1. / 16., 1e-9);
    EXPECT_NEAR(energy.scheme, 0., options.kind == SchemeKind::sdirk4 ? 1e-9 : 1e-6);
    EXPECT_EQ(energy.drag, 0.);
  }
}

// With rho_inf = 1 and a constant force generalised-alpha is the trapezoidal rule, which conserves energy.
TEST(Energy, IsNotTakenByAlphaAtRhoOne) {
  const System system = oscillator(2., 0., 8., constant());
  const auto scheme = make_scheme(system, {SchemeKind::generalised_alpha, 1.});
  march(system, *scheme, make_time_grid({}, 20., 0.05));
  EXPECT_NEAR(scheme->energy().scheme, 0., 1e-4 * scheme->energy().largest_work);
}

TEST(Energy, StoredTermsAreThoseOfTheState) {
  System system = sample_system({});
  system.loads = {sample_load(system, smooth())};
  const auto scheme = make_scheme(system, sdirk4);
  const State state = march(system, *scheme, make_time_grid({}, 2., 0.1)).final_state;
  const EnergyAccount& energy = scheme->energy();
  const Vector v = state.v.head(10), phi = state.v.tail(3);
  EXPECT_NEAR(energy.strain, 0.5 * state.x.dot(system.K * state.x), 1e-14);
  EXPECT_NEAR(energy.kinetic, 0.5 * v.dot(system.M.topLeftCorner(10, 10) * v), 1e-14);
  EXPECT_NEAR(energy.fluid, -0.5 * phi.dot(system.M.bottomRightCorner(3, 3) * phi), 1e-14);
}

TEST(Energy, AccountChangesNothingAndMayBeSwitchedOff) {
  System system = sample_system({});
  system.loads = {sample_load(system, smooth())};
  for (SchemeKind kind : {SchemeKind::sdirk4, SchemeKind::generalised_alpha}) {
    const State with = state_at(system, {kind, 0.9, true}, 2., 40),
                without = state_at(system, {kind, 0.9, false}, 2., 40);
    EXPECT_EQ(with.x, without.x);
    EXPECT_EQ(make_scheme(system, {kind, 0.9, false})->energy().work, 0.);
  }
}

}  // namespace energy_test
