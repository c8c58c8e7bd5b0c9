// Claim: the soil's laws are the formulas of their sources, and the deviation of Rayleigh damping from the damping
// that was asked for is reported.
#include "upbead/model/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace upbead {
namespace soil_test {

TEST(StressLaw, IsAPowerOfTheStressAboveItsFloor) {
  const StressLaw law{180e6, 98e3, 0.5, {}};
  EXPECT_DOUBLE_EQ(shear_modulus(law, 98e3, 0.), 180e6);
  EXPECT_DOUBLE_EQ(shear_modulus(law, 4. * 98e3, 0.), 360e6);
  EXPECT_DOUBLE_EQ(shear_modulus(law, 1., 24.5e3), 90e6);
}

TEST(StrainLaw, IsHardinsAndDrnevichs) {
  StrainLaw law;
  law.reference_strain = 4e-4;
  law.smallest_damping = 0.01;
  law.largest_damping = 0.25;
  EXPECT_DOUBLE_EQ(modulus_ratio(law, 0.), 1.);
  EXPECT_DOUBLE_EQ(modulus_ratio(law, 4e-4), 0.5);
  EXPECT_DOUBLE_EQ(damping_ratio(law, 0.), 0.01);
  EXPECT_DOUBLE_EQ(damping_ratio(law, 4e-4), 0.13);
}

TEST(StrainLaw, TakesTablesOverTheLogarithmOfTheStrain) {
  StrainLaw law;
  law.modulus = {{1e-5, 1.}, {1e-3, 0.4}};
  law.damping = {{1e-4, 0.02}, {1e-2, 0.2}};
  EXPECT_DOUBLE_EQ(modulus_ratio(law, 1e-7), 1.);
  EXPECT_NEAR(modulus_ratio(law, 1e-4), 0.7, 1e-12);
  EXPECT_DOUBLE_EQ(modulus_ratio(law, 1.), 0.4);
  EXPECT_NEAR(damping_ratio(law, 1e-3), 0.11, 1e-12);
}

TEST(Rayleigh, HoldsAtTheEndsOrOnTheBand) {
  for (const RayleighFit fit : {RayleighFit::ends, RayleighFit::band}) {
    const Rayleigh damping{0.05, {0.5, 20.}, fit};
    double worst = 0., least = 1., largest = 0.;
    for (double f = 0.5; f <= 20.; f *= 1.001) {
      worst = std::max(worst, std::abs(damping.ratio_at(f) / 0.05 - 1.));
      least = std::min(least, damping.ratio_at(f));
      largest = std::max(largest, damping.ratio_at(f));
    }
    EXPECT_NEAR(worst, damping.error(), 2e-3);
    if (fit == RayleighFit::ends)
      EXPECT_NEAR(damping.ratio_at(20.), 0.05, 1e-15);
    else
      EXPECT_NEAR(largest - 0.05, 0.05 - least, 1e-4) << "as far above as below";
  }
  EXPECT_LT((Rayleigh{0.05, {1., 10.}, RayleighFit::band}).error(), (Rayleigh{0.05, {1., 10.}}).error());
}

TEST(Rayleigh, IsExactAtOneFrequency) {
  EXPECT_NEAR((Rayleigh{0.05, {3., 3.}, RayleighFit::band}).error(), 0., 1e-15);
}

}  // namespace soil_test
}  // namespace upbead
