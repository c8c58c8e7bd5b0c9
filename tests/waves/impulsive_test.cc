// Claim: alpha_I1 has the values of its formula, its maximum where the experiments had it, no jump between its
// branches, and is negative on low mounds.

#include "upbead/waves/goda.h"

#include <gtest/gtest.h>

#include <array>

namespace upbead {
namespace impulsive_test {

TEST(AlphaI1, HasTheValuesOfTheTable) {
  constexpr std::array<double, 6> berm{0., 0.05, 0.10, 0.12, 0.20, 0.30};
  constexpr std::array<double, 6> mound{0.2, 0.4, 0.5, 0.6, 0.7, 0.8};
  constexpr std::array<std::array<double, 6>, 6> value{{{-0.0005, -0.0039, -0.0166, -0.0279, -0.1794, -0.5076},
                                                        {0.0389, 0.0905, 0.2037, 0.2749, 0.4951, 0.1516},
                                                        {0.1011, 0.2460, 0.5507, 0.7067, 0.7066, 0.1956},
                                                        {0.2113, 0.5058, 0.9345, 1.0000, 0.5858, 0.1532},
                                                        {0.4038, 0.8258, 0.9456, 0.8535, 0.3650, 0.0942},
                                                        {0.6734, 0.9052, 0.6900, 0.5655, 0.2083, 0.0533}}};
  for (std::size_t i = 0; i < mound.size(); ++i)
    for (std::size_t j = 0; j < berm.size(); ++j)
      EXPECT_NEAR(alpha_I1(berm[j], mound[i]), value[i][j], 5.01e-5) << mound[i] << ", " << berm[j];
}

TEST(AlphaI1, IsLargestAtTheMostImpulsiveMound) {
  EXPECT_EQ(alpha_I1(0.12, 0.6), 1.);
  for (const double x : {0.11, 0.13})
    for (const double y : {0.59, 0.61}) EXPECT_LT(alpha_I1(x, y), 1.);
}

TEST(AlphaI1, DoesNotJumpBetweenItsBranches) {
  constexpr double e = 1e-9;
  // Across delta_22 = 0 (along y), and across delta_11 = 0 (along x), away from the point where both vanish.
  const double y = 0.6 + 0.36 / 0.93 * 0.1, x = 0.12 - 0.36 / 0.93 * 0.1;
  EXPECT_NEAR(alpha_I1(0.22, y - e), alpha_I1(0.22, y + e), 1e-7);
  EXPECT_NEAR(alpha_I1(x - e, 0.7), alpha_I1(x + e, 0.7), 1e-7);
}

TEST(AlphaI1, IsNegativeBelowItsThreshold) {
  // delta_22 = -pi / (2 x 4.9) = -0.3206 along B_M/L = 0.12.
  EXPECT_GT(alpha_I1(0.12, 0.6 - 0.3200 / 0.93), 0.);
  EXPECT_LT(alpha_I1(0.12, 0.6 - 0.3212 / 0.93), 0.);
}

TEST(AlphaI1, VanishesOnVeryWideBerms) {
  EXPECT_EQ(alpha_I1(1e4, 0.6), 0.);
}

TEST(AlphaI0, EndsAtTwo) {
  EXPECT_EQ(alpha_I0(6., 4.), 1.5);
  EXPECT_EQ(alpha_I0(8., 4.), 2.);
  EXPECT_EQ(alpha_I0(9., 4.), 2.);
}

}  // namespace impulsive_test
}  // namespace upbead
