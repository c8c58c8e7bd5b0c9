// Margins of a section whose numbers are random, against the formulas that they are made of; FORM and sampling against
// each other on the problem of sliding in closed form.
#include "reliability/section_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../waves/sections.h"
#include "reliability/methods.h"
#include "reliability/random_variables.h"
#include "upbead/sliding/pulse.h"
#include "upbead/waves/standing_stability.h"

namespace upbead {
namespace section_model_test {

RandomVariable variable(const std::string& acts_on, double mean, double deviation) {
  RandomVariable v;
  v.acts_on = acts_on;
  v.mean = mean;
  v.deviation = deviation;
  return v;
}

DesignTables section_with(const std::map<std::string, RandomVariable>& variables) {
  DesignTables tables;
  tables.section = test::stranger_section();
  tables.waves["design"].height = 8.;
  tables.waves["design"].period = 12.;
  tables.limits.sliding = 0.3;
  tables.limits.base_pressure = 600e3;
  tables.reliability.emplace();
  tables.reliability->variables = variables;
  return tables;
}

const SectionLimitState& state_of(const std::vector<SectionLimitState>& states, const std::string& name) {
  return *std::find_if(states.begin(), states.end(), [&](const SectionLimitState& s) { return s.name == name; });
}

double margin(SectionModel& model, const std::string& name, const std::vector<double>& x) {
  return state_of(section_limit_states(model.at(model.certain()), {}), name).margin(model.at(x));
}

TEST(SectionModel, CountsAndTellsSoilsWithoutAnAnswer) {
  DesignTables tables = section_with({{"a", variable("section.friction", 0.6, 0.1)}});
  tables.dynamics.emplace();
  SectionModel model(tables, [](const GroundWave& asked) -> GroundPoint {
    if (asked.section.friction > 0.65) throw NumericsError("it has not converged");
    return {3e6, 2e6, {}, {}};
  });
  EXPECT_EQ(model.at({0.6}).ground().why_not, "");
  EXPECT_EQ(model.n_unanswered(), 0);
  for (int twice = 0; twice < 2; ++twice) EXPECT_EQ(model.at({0.7}).ground().why_not, "it has not converged");
  EXPECT_EQ(model.n_unanswered(), 1);
  EXPECT_EQ(model.why_unanswered(), "it has not converged");
}

TEST(SectionModel, PutsValuesWhereVariablesAct) {
  SectionModel model(section_with({{"a", variable("section.friction", 0.6, 0.1)},
                                   {"b", variable("force", 1., 0.1)},
                                   {"c", variable("water_level", 0., 0.5)},
                                   {"d", variable("waves.design.height", 8., 1.)},
                                   {"e", variable("weight", 1., 0.05)}}));
  EXPECT_EQ(model.certain(), (std::vector<double>{0.6, 1., 0., 8., 1.}));
  const SectionPoint certain = model.at(model.certain()), other = model.at({0.5, 1.2, 1., 7., 1.1});
  EXPECT_EQ(other.section.friction, 0.5);
  EXPECT_EQ(other.section.water_depth, 13.);
  // W' falls by the rise's buoyancy and grows by a tenth of W
  EXPECT_NEAR(other.section.submerged_weight, 5.589e6 - 1030. * 9.81 * 20. + 0.1 * 7.004e6, 1.);
  DesignWave wave{7., 7. / 1.8, 12., 0.};
  const WavePressure goda = Goda(other.section, Water(), wave).at(7.);
  EXPECT_NEAR(other.pressure.force, 1.2 * goda.force, 1e-6 * goda.force);
  EXPECT_NEAR(other.pressure.uplift, goda.uplift, 1e-6 * goda.uplift);
  EXPECT_EQ(model.at(model.certain()).pressure.force, certain.pressure.force);  // nothing of another point is left
}

/// Each margin changes its sign where the formula passes its limit.
TEST(LimitStates, PassZeroWhereTheFormulasPassTheirLimits) {
  SectionModel model(section_with({{"a", variable("force", 1., 0.1)}, {"b", variable("uplift", 1., 0.1)}}));
  for (double force = 0.1; force < 6.; force += 0.01) {
    const std::vector<double> x{force, 1.3};
    const SectionPoint at = model.at(x);
    const Stability s = stability(at.section, at.pressure);
    EXPECT_EQ(margin(model, "sliding", x) < 0., s.safety_sliding < 1.) << force;
    EXPECT_EQ(margin(model, "overturning", x) < 0., s.safety_overturning < 1.) << force;
    EXPECT_EQ(margin(model, "heel_pressure", x) < 0., !s.heel_pressure || *s.heel_pressure > 600e3) << force;
    const double S = sliding_distance_exact(at.load.mass, at.load.resistance, at.load.pulse);
    EXPECT_EQ(margin(model, "sliding_distance", x) < 0., S > 0.3) << force;
    EXPECT_EQ(margin(model, "sliding_0_1", x) < 0., S > 0.1) << force;
  }
}

/// With the harbour above or below the sea, by stability(), which the checks of `waves` are made of.
TEST(LimitStates, PassZeroWhereTheFormulasDoWithSeaAndHarbourAtTwoLevels) {
  for (const double harbour : {-6.5, -3., -0.5, 2.}) {
    DesignTables tables = section_with({{"a", variable("force", 1., 0.1)}, {"l", variable("water_level", 0., 0.1)}});
    tables.section.harbour_level = harbour;
    tables.section.centroid = 9.2;
    SectionModel model(tables);
    for (double force = 0.1; force < 6.; force += 0.02) {
      const std::vector<double> x{force, 0.3};
      const SectionPoint at = model.at(x);
      const Section level = at_water_level(tables.section, tables.water, 0.3);
      const Stability s = stability(at.section, at.pressure, still_water(level, tables.water));
      EXPECT_EQ(margin(model, "sliding", x) < 0., s.safety_sliding < 1.) << harbour << " " << force;
      EXPECT_EQ(margin(model, "overturning", x) < 0., s.safety_overturning < 1.) << harbour << " " << force;
      EXPECT_EQ(margin(model, "heel_pressure", x) < 0., !s.heel_pressure || *s.heel_pressure > 600e3)
          << harbour << " " << force;
    }
  }
}

/// rel.toml of a stranger: a lower harbour raises P(heel) from 0.085 to 0.266 and 0.547, by plain samples of his own.
TEST(LimitStates, ALowerHarbourRaisesTheHeelPressure) {
  DesignTables tables =
      section_with({{"a", variable("force", 1., 0.2)}, {"b", variable("section.friction", 0.6, 0.06)}});
  tables.section.width = 14.;
  tables.section.weight = 4.9028e6;
  tables.section.submerged_weight = 3.912e6;
  const auto probability = [&](const std::string& name, double harbour) {
    tables.section.harbour_level = harbour;
    SectionModel model(tables);
    const auto states = section_limit_states(model.at(model.certain()), {});
    const auto found = find_design_point(
        [&](const std::vector<double>& u) {
          return state_of(states, name).margin(model.at({1. + 0.2 * u[0], 0.6 + 0.06 * u[1]}));
        },
        2);
    return *by_form(found).probability;
  };
  EXPECT_NEAR(probability("heel_pressure", 0.), 0.0846, 0.0005);
  EXPECT_NEAR(probability("heel_pressure", -3.), 0.266, 0.002);
  EXPECT_NEAR(probability("heel_pressure", -6.9), 0.547, 0.003);
  EXPECT_GT(probability("sliding", -3.), 1.5 * probability("sliding", 0.));
}

/// mu (W' + dW') - P - push = 0, where standing_answer() has a factor of 1.
TEST(Seaward, HasThePushOfAHigherHarbourOnce) {
  for (const double harbour : {0., 1.5, -2.}) {
    DesignTables tables = section_with({{"a", variable("force", 1., 0.1)}});
    tables.waves["design"].height = 4.;
    tables.section.harbour_level = harbour;
    SectionModel model(tables);
    const auto state = state_of(section_limit_states(model.at({1.}), seaward_force(tables)), "sliding_seaward");
    ASSERT_TRUE(state.margin);
    for (const double force : {0.5, 1., 2.}) {
      const Stability s = standing_answer(tables.section, tables.water, {4., 4. / 1.8, 12., 0.}, force).answer->seaward;
      const double scale = tables.section.friction * tables.section.submerged_weight;
      EXPECT_NEAR(state.margin(model.at({force})), (s.safety_sliding - 1.) * s.force / scale, 2e-3) << harbour;
    }
  }
}

TEST(Variables, OnLevelsAndAnglesMayBeNegative) {
  RandomVariables random{
      {"harbour", "crest"}, {variable("section.harbour_level", -3., 1.), variable("section.crest", 3., 1.)}, {}};
  const NumberedWarnings warnings = not_positive(random);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].what, testing::HasSubstr("section.crest is positive"));
}

/// FORM needs a slope where S = 0, and none of the margins may jump.
TEST(LimitStates, HaveMarginsThatFallSmoothlyWithTheForce) {
  SectionModel model(section_with({{"a", variable("force", 1., 0.1)}}));
  for (const char* name : {"sliding", "overturning", "sliding_distance", "heel_pressure"}) {
    double before = margin(model, name, {0.3}), slope_before = 0.;
    for (double force = 0.31; force < 6.; force += 0.01) {
      const double now = margin(model, name, {force}), slope = now - before;
      EXPECT_LT(slope, 0.) << name << " at " << force;
      if (slope_before < 0.) {
        EXPECT_NEAR(slope / slope_before, 1., 0.3) << name << " at " << force;
      }
      before = now;
      slope_before = slope;
    }
  }
}

TEST(LimitStates, WithoutALimitCannotBeAsked) {
  DesignTables tables = section_with({{"a", variable("force", 1., 0.1)}});
  tables.limits = {};
  SectionModel model(tables);
  const auto states = section_limit_states(model.at({1.}), {{}, 0., "not asked"});
  EXPECT_FALSE(state_of(states, "heel_pressure").margin);
  EXPECT_THAT(state_of(states, "heel_pressure").why_not, testing::HasSubstr("limits.base_pressure"));
  EXPECT_THAT(state_of(states, "sliding_distance").why_not, testing::HasSubstr("limits.sliding"));
}

TEST(LimitStates, FloatingFails) {
  SectionModel model(section_with({{"a", variable("uplift", 1., 0.1)}}));
  for (const char* name : {"sliding", "overturning", "sliding_distance", "heel_pressure"})
    EXPECT_LT(margin(model, name, {30.}), 0.) << name;
}

/// At heights between those that were solved, against a wave that is solved there.
TEST(Seaward, ForceIsThatOfTheStandingWave) {
  DesignTables tables = section_with({{"a", variable("force", 1., 0.1)}});
  tables.waves["design"].height = 4.;
  const SeawardForce table = seaward_force(tables);
  ASSERT_TRUE(table.of_height) << table.why_not;
  for (const double height : {1.3, 2.9, 4.1}) {
    const StandingResult solved = standing_answer(tables.section, tables.water, {height, height / 1.8, 12., 0.});
    ASSERT_TRUE(solved.answer) << solved.why_not;
    EXPECT_NEAR(table.of_height(height), solved.answer->seaward.force, 0.005 * solved.answer->seaward.force) << height;
  }
  EXPECT_EQ(table.of_height(50.), table.of_height(table.highest));
}

TEST(Seaward, IsNotAskedWhereTheWaveOfTheDesignBreaks) {
  DesignTables tables = section_with({{"a", variable("force", 1., 0.1)}});
  tables.waves["design"].height = 11.;
  EXPECT_THAT(seaward_force(tables).why_not, testing::HasSubstr("no standing wave of the design's height"));
}

TEST(Seaward, IsNotAskedWhereTheStandingWaveItselfIsRandom) {
  const SeawardForce none = seaward_force(section_with({{"tide", variable("water_level", 0., 0.5)}}));
  EXPECT_FALSE(none.of_height);
  EXPECT_THAT(none.why_not, testing::HasSubstr("tide changes the standing wave"));
}

RandomVariables of(const DesignTables& tables) {
  RandomVariables out{{}, complete_variables(tables), {}};
  for (const auto& [name, v] : tables.reliability->variables) out.names.push_back(name);
  return out;
}

DesignTables sliding_problem() {
  DesignTables tables = section_with({{"friction", variable("section.friction", 0.636, 0.1)},
                                      {"goda", variable("force", 0.91, 0.155)},
                                      {"height", variable("waves.design.height", 7.5, 1.)},
                                      {"weight", variable("weight", 1.02, 0.04)}});
  tables.reliability->variables["height"].kind = RandomKind::gumbel;
  tables.section.submerged_weight = 3.4e6;  // so light that plain samples see it fail
  tables.section.weight = 4.8e6;
  return tables;
}

struct Compared {
  double form, sorm, importance, subset, plain;
};

/// S of one wave above 0.1 m.
Compared compare(const Sampling& sampling) {
  const DesignTables tables = sliding_problem();
  const auto model = std::make_shared<SectionModel>(tables);
  const StandardSpace space(of(tables));
  const Margin g = [model, space](const std::vector<double>& u) {
    return sliding_margin(model->at(space.physical(u)), 0.1);
  };
  const DesignPointSearch found = find_design_point(g, space.size());
  return {*by_form(found).index, *by_sorm(g, found).index, *by_importance(g, {*found.point}, sampling).index,
          *by_subset(g, space.size(), sampling).index, *by_plain(g, space.size(), sampling).index};
}

void expect_near_plain(const Compared& beta) {
  EXPECT_NEAR(beta.form, beta.plain, 0.05);
  EXPECT_NEAR(beta.sorm, beta.plain, 0.05);
  EXPECT_NEAR(beta.importance, beta.plain, 0.05);
  EXPECT_NEAR(beta.subset, beta.plain, 0.05);
}

TEST(Sliding, HasTheIndexOfPlainSamplingByAllMethods) {
  expect_near_plain(compare({1, 20000, 200000, 0.01}));
}

TEST(Sliding, HasTheIndexOfTenMillionPlainSamplesAtLength) {
  const Compared beta = compare({1, 20000, 10000000, 0.01});
  expect_near_plain(beta);
  std::printf("form %.4f sorm %.4f importance %.4f subset %.4f plain %.4f\n", beta.form, beta.sorm, beta.importance,
              beta.subset, beta.plain);
}

}  // namespace section_model_test
}  // namespace upbead
