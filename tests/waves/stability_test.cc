// Claim: safety factors and heel pressure of Goda's example; r = 1 exactly where the safety factor is 1, and
// elsewhere r is not its inverse.

#include "upbead/waves/goda.h"

#include <gtest/gtest.h>

#include "sections.h"

namespace upbead::test {
namespace stability_test {

WavePressure pressure(PressureFormula formula) {
  return Goda(goda_section(), Water(), goda_wave()).at(goda_wave().height, formula);
}

TEST(Stability, IsThatOfTheBooksExample) {
  const Stability plain = stability(goda_section(), pressure(PressureFormula::goda));
  EXPECT_NEAR(plain.safety_sliding, 1.1687, 5e-5);
  EXPECT_NEAR(plain.safety_overturning, 2.5785, 5e-5);
  EXPECT_NEAR(plain.heel_pressure.value(), 291.31e3, 10.);
  const Stability extended = stability(goda_section(), pressure(PressureFormula::extended));
  EXPECT_NEAR(extended.safety_sliding, 1.1644, 5e-5);
  EXPECT_NEAR(extended.safety_overturning, 2.5691, 5e-5);
  EXPECT_NEAR(extended.heel_pressure.value(), 291.98e3, 10.);
}

TEST(Stability, HasRatioOneWhereTheSafetyFactorIsOne) {
  const WavePressure p = pressure(PressureFormula::extended);
  Section s = goda_section();
  s.submerged_weight = submerged_weight_for(1., s.friction, p);
  const Stability one = stability(s, p);
  EXPECT_NEAR(one.safety_sliding, 1., 1e-14);
  EXPECT_NEAR(one.ratio, 1., 1e-14);
}

TEST(Stability, RatioIsNotTheInverseOfTheSafetyFactor) {
  const Stability s = stability(goda_section(), pressure(PressureFormula::extended));
  EXPECT_GT(std::abs(s.ratio * s.safety_sliding - 1.), 0.02);
  const WavePressure p = pressure(PressureFormula::extended);
  EXPECT_NEAR(s.ratio, (p.force + 0.6 * p.uplift) / (p.force * s.safety_sliding + 0.6 * p.uplift), 1e-14);
  WavePressure dry = p;
  dry.uplift = dry.uplift_moment = 0.;
  const Stability without = stability(goda_section(), dry);
  EXPECT_NEAR(without.ratio * without.safety_sliding, 1., 1e-14);
}

TEST(Stability, FindsTheWeightForASafetyFactor) {
  const WavePressure p = pressure(PressureFormula::goda);
  Section s = goda_section();
  s.submerged_weight = submerged_weight_for(1.2, s.friction, p);
  EXPECT_NEAR(stability(s, p).safety_sliding, 1.2, 1e-14);
}

TEST(Stability, NothingPressesOnTheMoundWhereTheUpliftBearsTheWeight) {
  WavePressure p = pressure(PressureFormula::goda);
  for (const double share : {1., 1.5}) {
    p.uplift = share * goda_section().submerged_weight;
    EXPECT_FALSE(stability(goda_section(), p).heel_pressure) << "U/W' " << share;
  }
}

TEST(Stability, ToePressureIsContinuousWhereTheSeawardEdgeOpens) {
  const WavePressure p = pressure(PressureFormula::goda);
  Section s = goda_section();
  // t_e = B/3 where W' t - M_U - M_P = (W' - U) B/3.
  const double t =
      ((s.submerged_weight - p.uplift) * s.width / 3. + p.uplift_moment + p.force_moment) / s.submerged_weight;
  s.centroid = t * (1. - 1e-9);
  const double opened = stability(s, p).heel_pressure.value();
  s.centroid = t * (1. + 1e-9);
  EXPECT_NEAR(stability(s, p).heel_pressure.value() / opened, 1., 1e-7);
}

TEST(Stability, HasNoHeelPressureWhereItOverturns) {
  Section s = goda_section();
  s.centroid = 1.;
  EXPECT_LT(stability(s, pressure(PressureFormula::goda)).safety_overturning, 1.);
  EXPECT_FALSE(stability(s, pressure(PressureFormula::goda)).heel_pressure);
}

TEST(Stability, NothingPressesOnTheMoundWhereUpliftLifts) {
  Section s = goda_section();
  s.submerged_weight = 4e5;
  EXPECT_FALSE(stability(s, pressure(PressureFormula::goda)).heel_pressure);
  EXPECT_LT(stability(s, pressure(PressureFormula::goda)).safety_sliding, 0.);
}

}  // namespace stability_test
}  // namespace upbead::test
