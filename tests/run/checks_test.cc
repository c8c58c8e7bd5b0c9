// Claims: checks by formulas and by dynamics stand side by side, the worse governs, and a contradiction is a warning; a
// pressure in motion is not held against the limit that was made for p_e; what nothing pushes is not checked; the push
// of still water at two levels counts; a number beside its limit shows the difference; S without a bound does not hold.
#include "findings/find.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <tuple>

#include "output/checks.h"

namespace upbead {
namespace checks_test {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Scene scene() {
  Scene scene;
  scene.sliding.emplace();
  scene.limits.sliding = 0.3;
  scene.limits.base_pressure = 600e3;
  scene.limits.overturning = 1.2;
  return scene;
}

/// Slides with 1.6 against 1.8 MN/m, rebounds with 0.4 MN/m, presses with 3.8 MPa for a moment.
Summary summary() {
  Summary s;
  s.response.emplace();
  s.response->peak_force = 1.1e6;
  s.sliding.emplace();
  s.sliding->history.resistance = 1.8e6;
  s.sliding->history.peak_force = 1.6e6;
  s.sliding->history.peak_seaward = 0.4e6;
  s.base.emplace();
  s.base->peak_heel_pressure = 3.776e6;
  s.base->static_heel_pressure = 395e3;
  s.base->static_toe_pressure = 280e3;
  s.base->least_overturning_margin = 1.5;
  return s;
}

Check by_formulas(const std::string& name, double demand) {
  Check check = at_least_as(check_of(FailureMode::sliding, name, "", demand, "", ""), 1.);
  check.by = "formulas";
  check.wave = "storm";
  check.has_rival = true;
  return check;
}

const Check& named(const std::string& name, const Summary& s) {
  for (const Check& check : s.checks)
    if (check.name == name) return check;
  throw std::runtime_error("no check " + name);
}

Summary judged(Summary s, const Scene& given = scene()) {
  Finding formulas;
  formulas.checks = [](const Scene&, const Summary& of) { return of.formula_checks; };
  s.checks = checks_of(given, s, {formulas});
  s.warnings = route_warnings(s.checks);
  return s;
}

TEST(Checks, AVerdictAtRestSaysThatNothingJudgesTheLoads) {
  const auto text = [](FailureMode mode) {
    Check check;
    check.mode = mode;
    check.by = "statics";
    check.demand = 1.;
    check.capacity = 1.2;
    check.limit = "safety";
    check.holds = true;
    return verdict_of({check}, {}).text;
  };
  EXPECT_NE(text(FailureMode::strength).find("; no check judges what the loads do to it"), std::string::npos);
  EXPECT_EQ(text(FailureMode::tilt).find("no check judges"), std::string::npos);
}

TEST(Checks, TheWorseRouteGoverns) {
  Summary s = summary();
  EXPECT_EQ(verdict_of(judged(s).checks, {}).holds, true);
  s.formula_checks = {by_formulas("sliding by formulas", 0.952)};
  s = judged(s);
  const Verdict verdict = verdict_of(s.checks, s.warnings);
  EXPECT_EQ(verdict.holds, false);
  EXPECT_EQ(verdict.governing->name, "sliding by formulas");
  EXPECT_EQ(verdict.failing, 1);
  EXPECT_TRUE(has(verdict.text, "wave storm: 0.952 against at least 1: DOES NOT HOLD"));
}

TEST(Checks, WhatFailsByLittleDoesNotLookLikeItsLimit) {
  const auto text = [](double demand, double capacity, const std::string& unit) {
    return text_of(at_most(check_of(FailureMode::sliding, "S", unit, demand, "", ""), capacity));
  };
  EXPECT_EQ(text(0.0277404, 0.0277403, "m"), "S: 27.7404 mm against 27.7403 mm: DOES NOT HOLD, margin 0.999996");
  EXPECT_EQ(text(561010., 561020., "Pa"), "S: 561.01 kPa against 561.02 kPa: holds, margin 1.00002");
  EXPECT_EQ(text(1.23442, 1.23441, ""), "S: 1.23442 against 1.23441: DOES NOT HOLD, margin 0.99999");
  EXPECT_EQ(text(0.3, 0.3, "m"), "S: 0.3 m against 0.3 m: holds, margin 1");
  EXPECT_EQ(text(0.25, 0.3, "m"), "S: 0.25 m against 0.3 m: holds, margin 1.2");
}

TEST(Checks, ACaissonThatSlidesOnHasNoDistanceThatHolds) {
  Summary s = summary();
  s.sliding->design.value = 0.01;
  EXPECT_EQ(named("sliding distance", judged(s)).holds, true);
  s.sliding->design.rests = false;
  const Check check = named("sliding distance", judged(s));
  EXPECT_EQ(check.holds, false);
  EXPECT_FALSE(check.demand);
}

TEST(Checks, AContradictionOfTheRoutesIsAWarningBothWays) {
  Summary s = summary();
  for (const auto& [safety, peak, warned] : {std::tuple(0.952, 1.6e6, true), std::tuple(1.05, 1.9e6, true),
                                             std::tuple(0.952, 1.9e6, false), std::tuple(1.05, 1.6e6, false)}) {
    s.sliding->history.peak_force = peak;
    s.formula_checks = {by_formulas("whatever its name", safety)};
    const Summary found = judged(judged(s));
    EXPECT_EQ(found.warnings.size(), warned ? 1U : 0U) << safety << " " << peak;
    if (warned) {
      EXPECT_EQ(found.warnings.front().name, "routes_differ");
      EXPECT_TRUE(has(found.warnings.front().text(), "the worse governs"));
    }
  }
}

TEST(Checks, ACheckOfAnotherWayToFailOrWithoutRivalContradictsNothing) {
  Summary s = summary();
  for (const auto& [mode, has_rival] : {std::pair(FailureMode::tilt, true), std::pair(FailureMode::sliding, false)}) {
    Check check = by_formulas("sliding by formulas", 0.952);
    check.mode = mode;
    check.has_rival = has_rival;
    s.formula_checks = {check};
    EXPECT_TRUE(judged(s).warnings.empty());
  }
}

TEST(Checks, APressureInMotionHasALimitOfItsOwn) {
  Scene given = scene();
  Summary s = judged(summary(), given);
  EXPECT_FALSE(named("heel pressure in motion", s).holds);
  EXPECT_EQ(named("heel pressure p_e of the loads", s).holds, true) << "395 kPa of 600";
  given.limits.dynamic_base_pressure = 2e6;
  EXPECT_EQ(named("heel pressure in motion", judged(s, given)).holds, false);
  given.limits.base_pressure = 300e3;
  EXPECT_EQ(named("heel pressure p_e of the loads", judged(s, given)).holds, false);
  s.base->static_heel_pressure.reset();
  EXPECT_EQ(named("heel pressure p_e of the loads", judged(s, given)).holds, false) << "the resultant leaves the base";
}

TEST(Checks, SeawardIsNotCheckedWhereNothingPushesSeaward) {
  const char* const name = "force against friction, seaward";
  Summary s = summary();
  const Summary found = judged(s);
  const Check& none = named(name, found);
  EXPECT_FALSE(none.holds);
  EXPECT_FALSE(none.margin);
  EXPECT_TRUE(has(text_of(none), "not checked: no trough acts"));
  s.sliding->history.peak_seaward = 1.9e6;
  EXPECT_EQ(named(name, judged(s)).holds, false) << "the rebound alone slides it";
  s.sliding->history.peak_seaward = 0.4e6;
  s.response->peak_force_seaward = -0.3e6;
  EXPECT_EQ(named(name, judged(s)).holds, true) << "a trough acts";
  s.response->peak_force_seaward = 0.;
  Scene shaken = scene();
  shaken.loads["base"].kind = LoadKind::acceleration;
  EXPECT_EQ(named(name, judged(s, shaken)).holds, true) << "a motion acts both ways";
}

TEST(Checks, AWayThatGoesOnFailsALimitThatItExceedsAndMeetsNone) {
  Summary s = summary();
  s.sliding->design.why_not_all = "it still slides";
  s.sliding->design.value = 0.2;
  EXPECT_EQ(named("sliding distance", judged(s)).why_not, "it still slides");
  EXPECT_FALSE(named("sliding distance", judged(s)).holds);
  s.sliding->design.value = -0.4;
  EXPECT_EQ(named("sliding distance", judged(s)).holds, false);
}

TEST(Checks, ThePushOfAHarbourCountsAndAWarningMayVoidTheVerdict) {
  Summary s = summary();
  s.harbour = HarbourSummary{9., 4.5, 0.25e6, 0.3e6};
  s = judged(s);
  EXPECT_NEAR(*named("force against friction", s).demand, 1.85e6, 1.);
  EXPECT_EQ(named("force against friction", s).holds, false);
  s.harbour->push = 0.1e6;
  s = judged(s);
  EXPECT_EQ(verdict_of(s.checks, s.warnings).holds, true);
  NumberedWarning warning{"harbour_level", 4.5, 9., "m", "two levels", "give both sides one level"};
  warning.voids = true;
  const Verdict verdict = verdict_of(s.checks, {warning});
  EXPECT_FALSE(verdict.holds);
  EXPECT_EQ(verdict.why_void, "harbour_level");
  EXPECT_TRUE(has(verdict.text, "VOID"));
}

TEST(Checks, OfSeveralLevelsTheWorstIsKept) {
  Check high = by_formulas("sliding by formulas", 0.952), low = by_formulas("sliding by formulas", 0.903);
  high.level = "high";
  low.level = "low";
  Check unjudged = at_most(check_of(FailureMode::heel_pressure, "heel pressure p_e", "Pa", 5e5, "", ""), {}),
        more = unjudged;
  more.demand = 5.6e5;
  const Checks worst = worst_of_each({{high, unjudged}, {low, more}});
  ASSERT_EQ(worst.size(), 2U);
  EXPECT_EQ(worst[0].level, "low");
  EXPECT_EQ(*worst[1].demand, 5.6e5);
  Check none = at_most(check_of(FailureMode::heel_pressure, "heel pressure p_e", "Pa", {}, "", ""), 6e5);
  EXPECT_EQ(none.holds, false) << "beyond all numbers";
  EXPECT_TRUE(
      is_worse(none, at_most(check_of(FailureMode::heel_pressure, "heel pressure p_e", "Pa", 7e5, "", ""), 6e5)));
}

}  // namespace checks_test
}  // namespace upbead
