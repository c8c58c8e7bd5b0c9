// Claims: N_l cycles build the whole effective stress; a larger shear needs fewer, by the power 1/beta; densification
// over many cycles is that of Byrne's law half cycle by half cycle, counted or in closed form.
#include "material/cyclic_soil.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead {
namespace cyclic_soil_test {

const CyclicStrength soil{0.254, -0.275};  // D_r = 0.5

TEST(CyclicSoil, LiquefiesWhereTheCurveSays) {
  for (const double N : {1., 10., 300.})
    EXPECT_NEAR(soil.cycles_to_liquefy(soil.alpha * std::pow(N, soil.beta)), N, 1e-10 * N);
  EXPECT_TRUE(std::isinf(soil.cycles_to_liquefy(0.)));
}

TEST(CyclicSoil, BuildsItsEffectiveStressInThatManyCycles) {
  const double stress = 40e3, shear = 4e3, N = soil.cycles_to_liquefy(shear / stress);
  EXPECT_NEAR(N * pressure_of_cycle(soil, shear, stress), stress, 1e-10 * stress);
  // the exponent of the source is -1/beta > 0: more shear, more pressure
  EXPECT_NEAR(pressure_of_cycle(soil, 2. * shear, stress) / pressure_of_cycle(soil, shear, stress),
              std::pow(2., -1. / soil.beta), 1e-9);
  EXPECT_EQ(pressure_of_cycle(soil, 0., stress), 0.);
  EXPECT_EQ(pressure_of_cycle(soil, stress, stress), stress);  // not more in one cycle
}

TEST(CyclicSoil, CompactsAsCyclesCountedOneByOne) {
  const ShearCompaction law{0.43, 0.93, 1e-5};
  const double gamma = 1e-3;
  ShearCycles counted(law);
  for (int half = 0; half < 40; ++half) counted.add({0., 0., half % 2 == 0 ? 0.5 * gamma : -0.5 * gamma});
  // the first way from rest is half as long as those that follow
  const double first = law.of_half_cycle(0.5 * gamma, 0.);
  EXPECT_NEAR(compaction_after(law, gamma, 19.5, first), counted.compaction(), 1e-12);
  EXPECT_EQ(compaction_after(law, 0.9e-5, 100., 0.), 0.);
  EXPECT_EQ(compaction_after(law, 0.9e-5, 100., 0.01), 0.01);
}

TEST(CyclicSoil, CompactsBeyondTenThousandHalfCyclesInClosedForm) {
  const ShearCompaction law{0.43, 0.93, 0.};
  const double gamma = 1e-3;
  double strain = 0.;
  for (int half = 0; half < 60000; ++half) strain += law.of_half_cycle(gamma, strain);
  EXPECT_NEAR(compaction_after(law, gamma, 30000., 0.), strain, 1e-5 * strain);
  EXPECT_NEAR(compaction_after(law, gamma, 10000., compaction_after(law, gamma, 20000., 0.)), strain, 1e-5 * strain);
}

}  // namespace cyclic_soil_test
}  // namespace upbead
