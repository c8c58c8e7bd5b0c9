// Claims: the worst value of a history is found with its time, and does not exist if the resultant leaves the bottom;
// the overturning margin is Goda's if nothing moves.

#include "upbead/sliding/base_pressure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead {
namespace base_pressure_test {

const std::vector<double> times{0.1, 0.2, 0.3, 0.4};

/// At rest; pushed landward with uplift; pulled seaward and pressed down; pushed a little.
EffectiveBase pushed_and_pulled() {
  EffectiveBase b;
  b.width = 12.;
  b.weight = 1.2e6;
  b.weight_moment = 0.6e6;
  b.uplift = {0., 0.2e6, 0., 0.};
  b.uplift_moment = {0., 0.4e6, 0., 0.};
  b.force = {1.2e6, 1.0e6, 1.4e6, 1.2e6};
  b.moment = {0.6e6, 2.5e6, -2.4e6, 0.8e6};
  return b;
}

EffectiveBase mirrored(EffectiveBase b) {
  b.weight_moment = -b.weight_moment;
  for (double& moment : b.uplift_moment) moment = -moment;
  for (double& moment : b.moment) moment = -moment;
  return b;
}

TEST(BaseExtremes, AreTheWorstOfAHistoryWithTheirTimes) {
  const BaseExtremes s = base_extremes(pushed_and_pulled(), times);
  EXPECT_NEAR(s.heel_pressure_at_rest, 1.25e5, 1e-9);
  EXPECT_NEAR(s.toe_pressure_at_rest, 0.75e5, 1e-9);
  EXPECT_DOUBLE_EQ(s.eccentricity_at_rest, 0.5);
  EXPECT_NEAR(s.peak_heel_pressure.value(), 2e6 / (3. * 3.5), 1e-9);
  EXPECT_EQ(s.peak_heel_pressure_time, 0.2);
  EXPECT_NEAR(s.peak_toe_pressure.value(), 1.4e6 / 12. * (1. + 6. * (2.4 / 1.4) / 12.), 1e-9);
  EXPECT_EQ(s.peak_toe_pressure_time, 0.3);
  EXPECT_DOUBLE_EQ(s.largest_eccentricity, 2.5);
  EXPECT_EQ(s.largest_eccentricity_time, 0.2);
  EXPECT_EQ(s.least_normal_force, 1.0e6);
  EXPECT_EQ(s.least_normal_force_time, 0.2);
}

TEST(BaseExtremes, CountThePushOfStillWaterAmongWhatOverturns) {
  EffectiveBase b = pushed_and_pulled();
  b.push_moment = 0.3e6;
  b.weight_moment += b.push_moment;
  for (double& moment : b.moment) moment += b.push_moment;
  const BaseExtremes s = base_extremes(b, times);
  EXPECT_NEAR(s.least_overturning_margin.value(), (1.2e6 * 5.5 - 0.2e6 * 6. - 0.4e6) / (1.5e6 + 0.3e6), 1e-12);
}

TEST(BaseExtremes, HoldGodasOverturningMargin) {
  // about the heel at 0.2 s, where the wave brings 1.5 MN m/m: (W' t - M_U)/M_P, M_U about the heel 0.2 * 6 + 0.4
  const BaseExtremes s = base_extremes(pushed_and_pulled(), times);
  EXPECT_NEAR(s.least_overturning_margin.value(), (1.2e6 * 5.5 - 0.2e6 * 6. - 0.4e6) / 1.5e6, 1e-12);
  EXPECT_EQ(s.least_overturning_margin_time, 0.2);
  // about the toe, only at 0.3 s: the downward force of 0.2 MN/m also holds the caisson
  EffectiveBase pulled = pushed_and_pulled();
  pulled.moment[1] = 1.0e6;
  pulled.moment[3] = 0.6e6;
  const BaseExtremes seaward = base_extremes(pulled, times);
  EXPECT_NEAR(seaward.least_overturning_margin.value(), 1.2e6 * 6.5 / (3e6 - 0.2e6 * 6.), 1e-12);
  EXPECT_EQ(seaward.least_overturning_margin_time, 0.3);
}

TEST(BaseExtremes, CountVerticalLoadsWithTheWeight) {
  // 0.2 MN/m more weight, 1 m landward of the middle: as W', or as a load
  EffectiveBase heavier = pushed_and_pulled(), loaded = heavier;
  for (EffectiveBase* b : {&heavier, &loaded}) {
    for (double& force : b->force) force += 0.2e6;
    for (double& moment : b->moment) moment += 0.2e6;
  }
  heavier.weight += 0.2e6;
  heavier.weight_moment += 0.2e6;
  loaded.vertical = loaded.vertical_moment = {0.2e6, 0.2e6, 0.2e6, 0.2e6};
  const BaseExtremes by_weight = base_extremes(heavier, times), by_load = base_extremes(loaded, times);
  EXPECT_DOUBLE_EQ(by_load.least_overturning_margin.value(), by_weight.least_overturning_margin.value());
  EXPECT_NE(by_load.least_overturning_margin, base_extremes(pushed_and_pulled(), times).least_overturning_margin);
}

TEST(BaseExtremes, HaveNoMarginBelowZeroWhereLoadsLiftMoreThanTheWeight) {
  EffectiveBase lifted = pushed_and_pulled();
  lifted.vertical = {0., 0., -2e6, 0.};
  lifted.vertical_moment = {0., 0., 0., 0.};
  lifted.force[2] -= 2e6;
  const BaseExtremes s = base_extremes(lifted, times);
  EXPECT_EQ(s.least_overturning_margin, 0.);
  EXPECT_EQ(s.least_overturning_margin_time, 0.3);
}

TEST(BaseExtremes, HaveNoMarginWhereOnlyRoundOffOverturns) {
  EffectiveBase still = pushed_and_pulled();
  still.uplift = still.uplift_moment = {0., 0., 0., 0.};
  still.force = {1.2e6, 1.2e6, 1.2e6, 1.2e6};
  still.moment = {0.6e6, 0.6e6 + 1e-4, 0.6e6 - 1e-4, 0.6e6};
  EXPECT_FALSE(base_extremes(still, times).least_overturning_margin);
}

TEST(BaseExtremes, AreThoseOfTheMirrorImage) {
  const BaseExtremes s = base_extremes(pushed_and_pulled(), times),
                     m = base_extremes(mirrored(pushed_and_pulled()), times);
  EXPECT_EQ(m.peak_toe_pressure, s.peak_heel_pressure);
  EXPECT_EQ(m.peak_heel_pressure, s.peak_toe_pressure);
  EXPECT_EQ(m.peak_toe_pressure_time, s.peak_heel_pressure_time);
  EXPECT_EQ(m.toe_pressure_at_rest, s.heel_pressure_at_rest);
  EXPECT_EQ(m.largest_eccentricity, -s.largest_eccentricity);
  EXPECT_EQ(m.least_overturning_margin, s.least_overturning_margin);
}

TEST(BaseExtremes, HaveNoPeakOnceTheResultantHasLeftTheBase) {
  EffectiveBase b = pushed_and_pulled();
  b.moment[1] = 6.01 * b.force[1];  // beyond the heel
  b.moment[3] = 5.99 * b.force[3];  // still within the bottom, later
  const BaseExtremes s = base_extremes(b, times), m = base_extremes(mirrored(b), times);
  EXPECT_FALSE(s.peak_heel_pressure);
  EXPECT_EQ(s.peak_heel_pressure_time, 0.2);
  EXPECT_TRUE(s.peak_toe_pressure);
  EXPECT_FALSE(m.peak_toe_pressure);
  EXPECT_TRUE(m.peak_heel_pressure);
  EXPECT_EQ(worst_of(s).heel_pressure, WorstBase::leaves);
  EXPECT_EQ(worst_of(m).toe_pressure, WorstBase::leaves);
}

TEST(BaseExtremes, TellWhenAnEdgeFirstParts) {
  const EffectiveBase b = pushed_and_pulled();
  const BaseExtremes s = base_extremes(b, times), m = base_extremes(mirrored(b), times);
  EXPECT_EQ(s.lifts_time, 0.2) << "e = 2.5 m beyond B/6 = 2 m";
  EXPECT_EQ(s.lifts, "seaward");
  EXPECT_EQ(m.lifts_time, 0.2);
  EXPECT_EQ(m.lifts, "landward");
  EffectiveBase calm = b;
  calm.moment = {0.6e6, 1.9e6, -1.9e6, 0.8e6};
  EXPECT_FALSE(base_extremes(calm, times).lifts_time);
  EffectiveBase afloat = calm;
  afloat.force[2] = -1.;
  EXPECT_EQ(base_extremes(afloat, times).lifts, "all");
  EXPECT_EQ(base_extremes(afloat, times).lifts_time, 0.3);
}

TEST(BaseExtremes, HaveNoEccentricityWhereNothingPresses) {
  EffectiveBase b = pushed_and_pulled();
  b.force[1] = -0.1e6;
  b.moment = {0.6e6, 0., 0.7e6, 0.72e6};
  const BaseExtremes s = base_extremes(b, times);
  EXPECT_EQ(s.least_normal_force, -0.1e6);
  EXPECT_DOUBLE_EQ(s.largest_eccentricity, 0.6) << "of the last step";
  EXPECT_FALSE(s.peak_heel_pressure);
  EXPECT_FALSE(s.peak_toe_pressure);
}

TEST(WorstBase, CountsRestAndTheWorstOfBothQuantityByQuantity) {
  BaseExtremes calm;
  calm.heel_pressure_at_rest = 3.;
  calm.toe_pressure_at_rest = 4.;
  calm.eccentricity_at_rest = -0.5;
  calm.peak_heel_pressure = 2.;
  calm.peak_toe_pressure = 5.;
  calm.largest_eccentricity = 0.4;
  const WorstBase a = worst_of(calm);
  EXPECT_EQ(a.heel_pressure, 3.);
  EXPECT_EQ(a.toe_pressure, 5.);
  EXPECT_EQ(a.eccentricity, -0.5);
  EXPECT_EQ(a.overturning_margin, WorstBase::leaves) << "nothing overturns";
  const WorstBase b{7., 1., 0.3, 2.};
  for (const WorstBase& both : {worst_of(a, b), worst_of(b, a)}) {
    EXPECT_EQ(both.heel_pressure, 7.);
    EXPECT_EQ(both.toe_pressure, 5.);
    EXPECT_EQ(both.eccentricity, -0.5);
    EXPECT_EQ(both.overturning_margin, 2.);
  }
}

}  // namespace base_pressure_test
}  // namespace upbead
