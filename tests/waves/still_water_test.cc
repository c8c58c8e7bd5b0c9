// Claim: still water at two levels pushes, lifts and turns a caisson as its pressures, integrated, do; a push with the
// wave lowers every factor of safety, and one against it raises none of sliding or turning by its push.
#include <gtest/gtest.h>

#include <cmath>

#include "sections.h"
#include "upbead/waves/goda.h"
#include "upbead/waves/standing_stability.h"

namespace upbead::test {
namespace still_water_test {

const Water water;
const double rho_g = water.density * water.gravity;

TEST(StillWater, IsTheIntegralOfItsPressures) {
  for (const double back : {0., 4.2, 7.5, 11.}) {
    const double front = 7.5, B = 12.;
    const StillWater still = still_water(front, back, B, rho_g);
    double push = 0., moment = 0., relief = 0., turning = 0.;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double y = (i + 0.5) * 15. / n, x = (i + 0.5) * B / n;
      const double p = rho_g * (std::max(front - y, 0.) - std::max(back - y, 0.));
      push += p * 15. / n;
      moment += p * y * 15. / n;
      // under the base, against the sea's pressure everywhere
      const double less = rho_g * (front - back) * x / B;
      relief += less * B / n;
      turning += less * (B - x) * B / n;  // about the heel
    }
    EXPECT_NEAR(still.push, push, 1e-6 * rho_g * 100.);
    EXPECT_NEAR(still.push_moment, moment, 1e-6 * rho_g * 1000.);
    EXPECT_NEAR(still.weight, relief, 1e-6 * rho_g * 100.);
    EXPECT_NEAR(still.weight * B / 3., turning, 1e-6 * rho_g * 1000.);
  }
}

TEST(StillWater, HasOneLevelWhereNoneIsGiven) {
  const StillWater still = still_water(goda_section(), water);
  EXPECT_EQ(still.push, 0.);
  EXPECT_EQ(still.push_moment, 0.);
  EXPECT_EQ(still.weight, 0.);
}

TEST(StillWater, OfALowerHarbourIsInTheFactorsOfSafety) {
  Section s = goda_section();
  s.harbour_level = -1.5;
  const WavePressure p = Goda(s, water, goda_wave()).at(goda_wave().height);
  const StillWater still = still_water(s, water);
  const Stability one = stability(s, p), two = stability(s, p, still);
  const double W = s.submerged_weight + still.weight;
  EXPECT_NEAR(two.safety_sliding, s.friction * (W - p.uplift) / (p.force + still.push), 1e-12);
  const double resisting = s.submerged_weight * 7.5 + still.weight * 5. - p.uplift_moment;
  EXPECT_NEAR(two.safety_overturning, resisting / (p.force_moment + still.push_moment), 1e-12);
  EXPECT_NEAR(two.resistance, s.friction * W - still.push, 1e-6);
  EXPECT_LT(two.safety_sliding, one.safety_sliding);
  EXPECT_LT(two.safety_overturning, one.safety_overturning);
  EXPECT_GT(*two.heel_pressure, *one.heel_pressure);
}

TEST(StillWater, OfAHigherHarbourLiftsButItsPushAgainstTheWaveIsLeftOut) {
  Section s = goda_section();
  s.harbour_level = 1.;
  const WavePressure p = Goda(s, water, goda_wave()).at(goda_wave().height);
  const StillWater still = still_water(s, water);
  EXPECT_LT(still.push, 0.);
  const Stability two = stability(s, p, still);
  EXPECT_NEAR(two.safety_sliding, s.friction * (s.submerged_weight + still.weight - p.uplift) / p.force, 1e-12);
}

TEST(StillWater, PushesTheCaissonSeawardInTheTroughWhereTheHarbourIsHigher) {
  const DesignWave wave{3., 1.67, 9., 0.};
  Section s = goda_section();
  const Stability level = standing_answer(s, water, wave).answer->seaward;
  s.harbour_level = 1.;
  const Stability higher = standing_answer(s, water, wave).answer->seaward;
  const StillWater still = still_water(s, water);
  const StandingExtremes worst = standing_answer(s, water, wave).answer->worst;
  EXPECT_NEAR(higher.safety_sliding,
              s.friction * (s.submerged_weight + still.weight) / (-worst.seaward.force - still.push), 1e-9);
  // about the toe, W' has the arm B/2 and the lift under the landward edge 2B/3
  EXPECT_NEAR(higher.safety_overturning,
              (s.submerged_weight * 7.5 + still.weight * 10.) / (-worst.seaward.force_moment - still.push_moment),
              1e-9);
  EXPECT_LT(higher.safety_sliding, level.safety_sliding);
}

TEST(TurnedAngle, IsThatOfTheChartLessFifteenDegrees) {
  EXPECT_DOUBLE_EQ(turned_angle(250., 230.).to_normal, 20.);
  EXPECT_DOUBLE_EQ(turned_angle(250., 230.).turned, 5.);
  EXPECT_DOUBLE_EQ(turned_angle(220., 230.).turned, 0.) << "turned by up to 15 degrees, not beyond the normal";
  EXPECT_DOUBLE_EQ(turned_angle(10., 350.).to_normal, 20.) << "across north";
  EXPECT_DOUBLE_EQ(turned_angle(350., 10.).turned, 5.);
  EXPECT_DOUBLE_EQ(turned_angle(0., 180.).to_normal, 180.) << "from behind";
}

}  // namespace still_water_test
}  // namespace upbead::test
