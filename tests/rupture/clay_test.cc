// Claims: of clay without friction, a circle has the factor of its closed form c_u 2 theta R^2 / moment; the least of
// all circles is that of Fellenius (1927), 5.52 c_u under a strip (also Skempton 1951), and of Taylor (1937), Stability
// of earth slopes, J. Boston Soc. Civ. Eng. 24(3): gamma H/c = 3.83, 4.57 and 5.24 of slopes of 90, 75 and 60 degrees.

#include <gtest/gtest.h>

#include <cmath>

#include "rupture/circle_search.h"
#include "slopes.h"

namespace upbead::test {
namespace clay_test {

const double pi = std::acos(-1.);

GroundSection level_clay(double cohesion) {
  return section_of({{soil_of(18e3, cohesion, 0.), {{-50., 0.}, {50., 0.}}}}, -40.);
}

TEST(Clay, UnderAStripHasTheFactorOfItsClosedForm) {
  GroundLoads loads;
  loads.strip = {-3., 3., 100e3, 100e3, 40e3, 0.};
  const SlipCircle circle{4., 5., 9.};
  const double half = std::sqrt(81. - 25.), theta = std::acos(5. / 9.);
  const double moment = 100e3 * 6. * 4. + 40e3 * 5.;
  for (const SlipsTo slips : {SlipsTo::right, SlipsTo::left}) {
    const FigureSafety found = circle_safety(level_clay(30e3), loads, circle, slips, 4. - half, 4. + half, 4000);
    if (slips == SlipsTo::left)
      EXPECT_EQ(found.why, NoFactor::nothing_drives);
    else
      EXPECT_NEAR(found.factor, 30e3 * 2. * theta * 81. / moment, 1e-3);
  }
}

TEST(Clay, BearsOnCirclesWhatFelleniusFound) {
  GroundLoads loads;
  loads.strip = {-3., 3., 100e3, 100e3, 0., 0.};
  const CircleSearch found =
      search_circles(level_clay(30e3), loads, SlipsTo::right, range_beside(level_clay(30e3), *loads.strip));
  ASSERT_FALSE(found.family.empty());
  EXPECT_NEAR(found.family[0].safety.factor * 100. / 30., 5.52, 0.01);
}

TEST(Clay, OfASlopeHasTaylorsNumbers) {
  for (const auto& [degrees, number] : {std::pair{89.99, 3.83}, {75., 4.57}, {60., 5.24}}) {
    const double run = 10. / std::tan(degrees * pi / 180.);
    const GroundSection section =
        section_of({{soil_of(20e3, 40e3, 0.), {{-30., 10.}, {0., 10.}, {run, 0.}, {run + 30., 0.}}}}, -20.);
    SearchOptions options;
    options.n_slices = options.n_slices_found = 300;
    const CircleSearch found = search_circles(section, {}, SlipsTo::right, {{-30., -1e-6}, {run, run + 30.}}, options);
    ASSERT_FALSE(found.family.empty());
    EXPECT_NEAR(found.family[0].safety.factor * 20. * 10. / 40., number, 0.01) << degrees;
  }
}

}  // namespace clay_test
}  // namespace upbead::test
