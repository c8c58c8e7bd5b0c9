// Margins by F_T and the forces on the base, of what a ground would answer.
#include <gtest/gtest.h>

#include <algorithm>

#include "reliability/section_model.h"

namespace upbead {
namespace ground_states_test {

SectionPoint on(const GroundPoint& answer) {
  SectionPoint at;
  at.section.friction = 0.6;
  at.section.submerged_weight = 5e6;
  at.limits.sliding = 0.3;
  at.limits.base_pressure = 600e3;
  at.ground = [answer]() -> const GroundPoint& { return answer; };
  return at;
}

double margin(const std::string& name, const GroundPoint& answer) {
  const SectionPoint at = on(answer);
  const auto states = ground_states(at, true);
  return std::find_if(states.begin(), states.end(), [&](const auto& s) { return s.name == name; })->margin(at);
}

GroundPoint pressed(double heel_pressure, double overturning_margin) {
  GroundPoint point{3e6, 2e6, 1e6, WorstBase()};
  point.base->heel_pressure = heel_pressure;
  point.base->overturning_margin = overturning_margin;
  return point;
}

TEST(GroundStates, PassZeroAtTheirLimits) {
  EXPECT_DOUBLE_EQ(margin("sliding_dynamic", pressed(0., 2.)), 1. / 3.);
  EXPECT_DOUBLE_EQ(margin("sliding_distance_dynamic", pressed(0., 2.)), 2. / 3.);
  EXPECT_DOUBLE_EQ(margin("overturning_dynamic", pressed(0., 1.)), 0.);
  EXPECT_DOUBLE_EQ(margin("overturning_dynamic", pressed(0., WorstBase::leaves)), 1.);
  EXPECT_DOUBLE_EQ(margin("heel_pressure_dynamic", pressed(600e3, 2.)), 0.);
}

/// p_e grows beyond all bounds as the resultant nears the edge; the margin goes on from -1 once it has left.
TEST(GroundStates, GoOnWhereTheResultantHasLeftTheBase) {
  EXPECT_NEAR(margin("heel_pressure_dynamic", pressed(1e15, 1.)), -1., 1e-8);
  EXPECT_DOUBLE_EQ(margin("heel_pressure_dynamic", pressed(WorstBase::leaves, 1.)), -1.);
  EXPECT_LT(margin("heel_pressure_dynamic", pressed(WorstBase::leaves, 0.9)), -1.1);
}

TEST(GroundStates, FailWhereASoilHasNoAnswer) {
  GroundPoint none;
  none.why_not = "it has not converged";
  for (const char* name :
       {"sliding_dynamic", "sliding_distance_dynamic", "overturning_dynamic", "heel_pressure_dynamic"})
    EXPECT_EQ(margin(name, none), -1.) << name;
}

TEST(GroundStates, SayWhatTheyLack) {
  SectionPoint at = on(pressed(1., 2.));
  at.limits = {};
  for (const SectionLimitState& state : ground_states(at, false)) EXPECT_EQ(!state.margin, !state.why_not.empty());
  EXPECT_EQ(ground_states(at, false)[2].why_not, "the model of [dynamics] has no readings of the base");
  EXPECT_NE(ground_states(at, true)[1].why_not.find("limits.sliding"), std::string::npos);
}

}  // namespace ground_states_test
}  // namespace upbead
