// Claim: the pressures of the edges balance N' and M'; there is none where the resultant leaves the bottom.

#include "upbead/waves/edge_pressures.h"

#include <gtest/gtest.h>

namespace upbead::test {
namespace edge_pressures_test {

TEST(EdgePressures, BalanceForceAndMomentOverTheWholeWidth) {
  for (const double e : {0., 0.7, -1.3, 2., -2.}) {
    const EdgePressures p = edge_pressures(1e6, 1e6 * e, 12.);
    EXPECT_NEAR(0.5 * (*p.seaward + *p.landward) * 12., 1e6, 1e-6) << "e " << e;
    EXPECT_NEAR((*p.landward - *p.seaward) * 144. / 12., 1e6 * e, 1e-6) << "e " << e;
  }
}

TEST(EdgePressures, BalanceThemOverTheWidthInContact) {
  for (const double e : {2.1, 4., 5.9}) {
    const EdgePressures p = edge_pressures(1e6, 1e6 * e, 12.), mirrored = edge_pressures(1e6, -1e6 * e, 12.);
    const double contact = 2. * 1e6 / *p.landward;
    EXPECT_NEAR(contact / 3., 6. - e, 1e-12) << "the resultant goes through the triangle's centroid";
    EXPECT_EQ(p.seaward, 0.);
    EXPECT_EQ(mirrored.seaward, p.landward);
    EXPECT_EQ(mirrored.landward, 0.);
  }
}

TEST(EdgePressures, GrowAboveAllNumbersAsTheResultantComesToTheEdgeAndThenAreNone) {
  double before = 0.;
  for (const double e : {5.9, 5.99, 5.999999}) {
    const double pressure = edge_pressures(1e6, 1e6 * e, 12.).landward.value();
    EXPECT_NEAR(pressure, 2e6 / (3. * (6. - e)), 1e-6 * pressure);
    EXPECT_GT(pressure, before);
    before = pressure;
  }
  for (const double e : {6., 7.}) {
    EXPECT_FALSE(edge_pressures(1e6, 1e6 * e, 12.).landward) << e;
    EXPECT_EQ(edge_pressures(1e6, 1e6 * e, 12.).seaward, 0.) << e;
    EXPECT_FALSE(edge_pressures(1e6, -1e6 * e, 12.).seaward) << e;
  }
  EXPECT_GT(above_all(std::nullopt), 1e300);
  EXPECT_EQ(above_all(3.), 3.);
}

TEST(EdgePressures, AreNoneWhereNothingPresses) {
  for (const double force : {0., -1e6}) {
    EXPECT_FALSE(edge_pressures(force, 1e6, 12.).landward);
    EXPECT_FALSE(edge_pressures(force, 1e6, 12.).seaward) << "it may come down on either edge";
    EXPECT_FALSE(edge_pressures(force, 0., 12.).seaward);
  }
}

}  // namespace edge_pressures_test
}  // namespace upbead::test
