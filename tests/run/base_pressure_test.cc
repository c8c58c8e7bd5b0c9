// Claim: edge pressures balance N' and M' exactly, whether the whole bottom is in contact or only a part of it.
#include "run/sliding/effective_base.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead {
namespace base_pressure_test {

constexpr double B = 18., N = 4e6;

TEST(EdgePressures, BalanceForceAndMomentOfAPressedBottom) {
  for (const double e : {-2.9, -1., 0., 0.5, 3.}) {
    const auto [seaward, landward] = edge_pressures(N, N * e, B);
    EXPECT_NEAR(0.5 * (seaward + landward) * B / N, 1., 1e-12) << e;
    EXPECT_NEAR((landward - seaward) * B * B / 12. / N, e, 1e-12) << e;
  }
}

TEST(EdgePressures, BalanceForceAndMomentOfAPartThatTouches) {
  for (const double e : {3.1, 5., 8.5}) {
    const auto [seaward, landward] = edge_pressures(N, N * e, B);
    EXPECT_EQ(seaward, 0.);
    const double touching = 2. * N / landward;  // a triangular pressure
    EXPECT_NEAR(0.5 * B - touching / 3., e, 1e-12) << e;
    const auto other = edge_pressures(N, -N * e, B);
    EXPECT_EQ(other.seaward, landward);
    EXPECT_EQ(other.landward, 0.);
  }
  EXPECT_NEAR(edge_pressures(N, N * B / 6., B).landward, edge_pressures(N, N * B / 6. * (1. + 1e-12), B).landward, 1.);
}

TEST(EdgePressures, AreFiniteWhereTheCaissonFalls) {
  for (const double e : {9., 9.5, 1e9}) EXPECT_TRUE(std::isfinite(edge_pressures(N, N * e, B).landward)) << e;
  EXPECT_EQ(edge_pressures(-1., 5., B).landward, 0.);
  EXPECT_EQ(edge_pressures(0., 5., B).seaward, 0.);
}

}  // namespace base_pressure_test
}  // namespace upbead
