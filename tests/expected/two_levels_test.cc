// Claims: with the harbour below or above the sea, laws by formulas are the formulas of one wave with that still water,
// at the sea state's own level; edge pressures and margin are those of stability(); the law dynamic slides under
// F_T + mu U and the push on mu (W' + dW'), and skips no wave that slides.
#include <gtest/gtest.h>

#include <cmath>

#include "expected/dynamic_law.h"
#include "oscillator.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/sliding/block.h"
#include "upbead/sliding/combined.h"
#include "upbead/sliding/pulse.h"

namespace upbead::test {

namespace two_levels_test {

Breakwater with_harbour(double level) {
  Breakwater caisson = medium_caisson();
  caisson.section.harbour_level = level;
  return caisson;
}

TEST(TwoLevels, FormulasAreThoseOfOneWaveThere) {
  for (const double level : {-3., -1., 1.}) {
    SeaState sea = storm(12. / 1.8);
    sea.water_level = 0.5;
    const Breakwater caisson = with_harbour(level);
    const Section there = at_water_level(caisson.section, caisson.water, 0.5);
    const WavePressure p = Goda(there, caisson.water, {0., sea.significant_height, sea.period, 0.}).at(12.);
    const Stability s = stability(there, p, still_water(there, caisson.water));
    const double tau_0 = caisson.k(p.alpha_star) * standing_duration(12., there.water_depth, sea.period);
    const double mass = there.weight / caisson.water.gravity;
    const TriangularPulse pulse{s.sliding_force, tau_0};
    EXPECT_DOUBLE_EQ(formula_law(Law::paper, caisson, sea)->distance(12.),
                     sliding_distance_paper(mass, s.resistance, pulse));
    EXPECT_DOUBLE_EQ(formula_law(Law::exact, caisson, sea)->distance(12.),
                     sliding_distance_exact(mass, s.resistance, pulse));
    EXPECT_GT(formula_law(Law::exact, caisson, sea)->distance(12.), 0.);
    EXPECT_NEAR(WaveForces(caisson, sea).excess(12., {}), s.sliding_force - s.resistance, 1e-9 * s.resistance);
    for (const Law law : {Law::paper, Law::exact, Law::combined}) {
      const auto of = formula_law(law, caisson, sea);
      EXPECT_EQ(of->distance(of->threshold() * (1. - 1e-9)), 0.);
      EXPECT_GT(of->distance(of->threshold() * (1. + 1e-4)), 0.);
    }
  }
  const double lower = formula_law(Law::exact, with_harbour(-3.), storm(6.))->distance(12.);
  EXPECT_GT(lower, formula_law(Law::exact, with_harbour(0.), storm(6.))->distance(12.));
}

TEST(TwoLevels, PressuresOnTheBaseAreThoseOfStability) {
  for (const double level : {-3., -1., 1.})
    for (const double H : {3., 6., 9.}) {
      const WaveForces forces(with_harbour(level), storm(6.));
      const Section& s = forces.breakwater().section;
      const StillWater& still = forces.still();
      const Stability goda = stability(s, forces.at(H, {}), still);
      const WorstBase base = forces.base(H, {});
      const double W = s.submerged_weight + still.weight;
      const double at_rest =
          above_all(edge_pressures(W, still.weight * s.width / 6. + still.push_moment, s.width).landward);
      const double worst = std::max(above_all(goda.heel_pressure), at_rest);
      EXPECT_NEAR(base.heel_pressure, worst, 1e-12 * worst) << level << " " << H;
      EXPECT_NEAR(base.overturning_margin, goda.safety_overturning, 1e-12 * goda.safety_overturning);
    }
}

TEST(TwoLevels, TheLawDynamicHasThePushInItsForce) {
  const auto answer = std::make_shared<const ShearAnswer>(oscillator(1.5, 0.1), 2e-3, 10.);
  const auto unbounded = std::make_shared<const ShearAnswer>(oscillator(1.5, 0.1), 2e-3, 0.1);  // nothing is skipped
  for (const double level : {-3., 1.}) {
    const Breakwater caisson = with_harbour(level);
    const StillWater still = still_water(caisson.section, caisson.water);
    const DynamicLaw law(caisson, storm(6.), {}, answer), all(caisson, storm(6.), {}, unbounded);
    const DynamicWave wave = law.wave(11.);
    History force{wave.time, wave.sliding_force};
    for (double& f : force.value) f += still.push;
    const double S =
        slide(caisson.section.weight / 9.81, force, 0.6 * (caisson.section.submerged_weight + still.weight)).residual;
    EXPECT_GT(S, 0.) << level;
    EXPECT_NEAR(law.distance(11., {}), S, 1e-9 * S) << level;
    for (double H = 1.; H < 13.; H += 0.5) EXPECT_EQ(law.distance(H, {}), all.distance(H, {})) << level << " " << H;
  }
}

}  // namespace two_levels_test
}  // namespace upbead::test
