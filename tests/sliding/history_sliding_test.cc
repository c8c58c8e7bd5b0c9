// Claim: the sliding of a caisson under one wave is the same whether uplift enters F_S, reduces the resistance, or is
// a change of the normal force.

#include "upbead/sliding/history_sliding.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead {
namespace history_sliding_test {

const BottomResistance bottom{6e5, 0.6, 3.5e6, 0.};
constexpr double R = 0.6 * 3.5e6;
const TriangularPulse pulse{3e6, 0.3};

TEST(HistorySliding, OfATriangleIsTheClosedForm) {
  const HistorySliding s = slide_history({history(pulse), {}, {}}, bottom);
  EXPECT_NEAR(s.by_history.residual, sliding_distance_exact(6e5, R, pulse), 1e-15);
  EXPECT_EQ(s.with_normal_force.residual, s.by_history.residual);
  EXPECT_DOUBLE_EQ(s.peak_force, 3e6);
  EXPECT_DOUBLE_EQ(s.ratio, 3e6 / R);
  EXPECT_DOUBLE_EQ(s.least_normal_force, 3.5e6);
  ASSERT_TRUE(s.own);
  EXPECT_NEAR(*s.own->by_exact, 0.3, 1e-12);
  ASSERT_EQ(s.table.size(), 7U);
  for (const HistoryDuration& d : s.table) EXPECT_NEAR(*d.by_exact, 0.3, 1e-12) << d.ratio;
}

TEST(HistorySliding, UpliftInPhaseIsPartOfThePulse) {
  // F_T + mu U with both triangles of one duration: the pulse of their sum
  History U = history({1e6, 0.3});
  const HistorySliding s = slide_history({history(pulse), U, {}}, bottom);
  const TriangularPulse whole{3e6 + 0.6 * 1e6, 0.3};
  EXPECT_NEAR(s.by_history.residual, sliding_distance_exact(6e5, R, whole), 1e-13);
  EXPECT_DOUBLE_EQ(s.peak_force, whole.peak);
  EXPECT_DOUBLE_EQ(s.peak_force_time, 0.15);
  EXPECT_DOUBLE_EQ(s.uplift_at_peak, 1e6);
  EXPECT_DOUBLE_EQ(s.shear_at_peak, 3e6);
  EXPECT_DOUBLE_EQ(s.least_normal_force, 2.5e6);
  EXPECT_NEAR(*s.own->by_exact, 0.3, 1e-12);
}

TEST(HistorySliding, AChangeOfTheNormalForceActsLikeUpliftOfTheOtherSign) {
  const History U{{0., 0.1, 0.2, 0.4}, {0., 8e5, 3e5, 0.}};
  History lift = U;
  for (double& value : lift.value) value = -value;
  const HistorySliding by_uplift = slide_history({history(pulse), U, {}}, bottom);
  const HistorySliding by_change = slide_history({history(pulse), {}, lift}, bottom);
  EXPECT_NEAR(by_change.with_normal_force.residual, by_uplift.by_history.residual, 1e-14);
  EXPECT_GT(by_uplift.by_history.residual, 1.01 * by_change.by_history.residual);
  EXPECT_DOUBLE_EQ(by_change.least_normal_force, 2.7e6);
  EXPECT_DOUBLE_EQ(by_change.peak_on_normal, by_uplift.peak_force);
  EXPECT_DOUBLE_EQ(by_uplift.peak_on_normal, by_uplift.peak_force);
  EXPECT_DOUBLE_EQ(by_change.peak_seaward_on_normal, by_uplift.peak_seaward);
}

TEST(HistorySliding, NothingHoldsACaissonThatIsLifted) {
  // U above W' from 0.1 to 0.3 s: no friction there; m x'' = F_T alone
  const History push{{0., 0., 0.4, 0.4}, {0., 1e6, 1e6, 0.}};
  const History U{{0.1, 0.1, 0.3, 0.3}, {0., 4e6, 4e6, 0.}};
  const HistorySliding s = slide_history({push, U, {}}, bottom);
  EXPECT_LT(s.least_normal_force, 0.);
  // accelerated for 0.2 s by 1e6 N/m, then braked by R - 1e6 until 0.4 s or rest
  const double v = 1e6 * 0.2 / 6e5, brake = (R - 1e6) / 6e5, stop = 0.1;
  ASSERT_GT(v / brake, stop);
  const double left = v - brake * stop;
  const double distance = 0.5 * v * 0.2 + v * stop - 0.5 * brake * stop * stop + left * left * 6e5 / (2. * R);
  EXPECT_NEAR(s.by_history.residual, distance, 1e-12);
}

TEST(HistorySliding, TellsTheUpliftAtThePeakBetweenItsOwnTimes) {
  const History U{{0., 0.3, 0.6}, {0., 6e5, 0.}};
  EXPECT_NEAR(slide_history({history({3e6, 0.2}), U, {}}, bottom).uplift_at_peak, 2e5, 1e-6);
  EXPECT_NEAR(slide_history({history({3e6, 0.8}), U, {}}, bottom).uplift_at_peak, 4e5, 1e-6);
}

TEST(HistorySliding, FrictionIsWholeAgainOnceTheUpliftIsOver) {
  // still moving when the uplift ends: braked by the whole mu W'
  const History push{{0., 0., 0.2, 0.2}, {0., 4e6, 4e6, 0.}};
  const History U{{0., 0., 0.2, 0.2}, {0., 1e6, 1e6, 0.}};
  const HistorySliding s = slide_history({push, U, {}}, bottom);
  const double a = (4e6 - 0.6 * 2.5e6) / 6e5, v = 0.2 * a;
  EXPECT_NEAR(s.by_history.residual, 0.5 * a * 0.04 + v * v * 6e5 / (2. * R), 1e-13);
}

TEST(HistorySliding, SeawardForcesSlideSeaward) {
  const HistorySliding s = slide_history({history({-3e6, 0.3}), {}, {}}, bottom);
  EXPECT_NEAR(s.by_history.residual, -sliding_distance_exact(6e5, R, pulse), 1e-15);
  EXPECT_EQ(s.peak_force, 0.);
  EXPECT_FALSE(s.own);
}

TEST(HistorySliding, DragTakesSomeOfIt) {
  BottomResistance slow = bottom;
  slow.drag = 1e6;
  EXPECT_LT(slide_history({history(pulse), {}, {}}, slow).by_history.residual,
            0.95 * slide_history({history(pulse), {}, {}}, bottom).by_history.residual);
}

}  // namespace history_sliding_test
}  // namespace upbead
