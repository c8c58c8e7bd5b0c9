// What the record and the lives say together: the distance to tell first, checks against [limits], warnings.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "case/formula_checks.h"
#include "design/expected_laws.h"
#include "design/expected_report.h"
#include "output/limits.h"
#include "waves/section_warnings.h"

namespace upbead {

namespace {

constexpr double mistaken = 2.;  // beyond what a sea brings by so much, a number is no scatter of a record
constexpr int few_lives = 50;    // with fewer lives that slide, a normal distribution of their mean is doubtful

const char* route_of(Law law) {
  return law == Law::dynamic ? "dynamics" : "formulas";
}

std::string told(Law law, double distance) {
  return std::string(word(law)) + " " + with_unit(distance, "m");
}

/// A number, or none where it is above all numbers.
std::optional<double> number_or_none(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Check routed(Check check, Law law) {
  check.by = route_of(law);
  return check;
}

/// What presses on the base in one wave, or in half of the lives: `what` says which.
struct Pressing {
  std::string what, key, assumption;
  Law law;
};

Check edge_check(const Pressing& of, const std::string& edge, double pressure, const Limits& limits) {
  const bool dynamic = of.law == Law::dynamic;
  const FailureMode mode = edge == "heel" ? FailureMode::heel_pressure : FailureMode::toe_pressure;
  return routed(held_to(check_of(mode, edge + (dynamic ? " pressure in motion, " : " pressure p_e, ") + of.what, "Pa",
                                 number_or_none(pressure), of.key + ".peak_" + edge + "_pressure", of.assumption),
                        limits, dynamic ? &Limits::dynamic_base_pressure : &Limits::base_pressure),
                of.law);
}

/// By formulas the caisson overturns below 1; a moment below 1 in motion is judged by a given limit alone.
Check overturning_check(const Pressing& of, double margin, const Limits& limits) {
  const Check check = check_of(FailureMode::overturning,
                               (of.law == Law::dynamic ? "overturning in motion, " : "overturning, ") + of.what, "",
                               number_or_none(margin), of.key + ".least_overturning_margin", of.assumption);
  if (!check.demand) return routed(not_checked(held_to(check, {}, &Limits::overturning), "nothing overturns"), of.law);
  const std::optional<double> natural = of.law == Law::dynamic ? std::nullopt : std::optional(1.);
  return routed(held_to(check, limits, &Limits::overturning, natural), of.law);
}

void add_base(const Pressing& of, const WorstBase& base, const Limits& limits, Checks& list) {
  list.push_back(edge_check(of, "heel", base.heel_pressure, limits));
  list.push_back(edge_check(of, "toe", base.toe_pressure, limits));
  list.push_back(overturning_check(of, base.overturning_margin, limits));
}

/// The value that half of the lives do not exceed; for a margin, that half of them reach.
double median(const WorstOfLives& worst) {
  std::vector<double> values = worst.values;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The share of the lives that slide farther than the limit.
void add_share(const MonteCarlo& lives, const std::string& key, const Limits& limits, Checks& list) {
  if (!limits.sliding) return;
  for (const Exceeded& e : lives.statistics.exceeded)
    if (e.limit == *limits.sliding)
      list.push_back(
          routed(held_to(check_of(FailureMode::sliding_distance,
                                  "share of lives that slide farther than " + with_unit(e.limit, "m"), "",
                                  e.probability, key + ".exceeded[].probability",
                                  "95 % interval " + significant(e.interval[0]) + " to " + significant(e.interval[1])),
                         limits, &Limits::lives_beyond),
                 lives.law));
}

/// Of each way to fail that only lives with slip circles know: the median of all lives, and the share beyond.
void add_ways(const MonteCarlo& lives, const std::string& key, const Limits& limits, Checks& list) {
  if (!lives.ways) return;
  const Limits none;
  const std::string of_half = "the median of all lives, of the least of each";
  const auto add = [&](FailureMode mode, const std::string& name, const WorstOfLives& worst, const std::string& measure,
                       std::optional<double> Limits::*limit) {
    const Check check =
        check_of(mode, name + ", of the median life", "", number_or_none(median(worst)), key + ".ways." + measure,
                 of_half + "; below " + significant(worst.beyond->limit) + " in " +
                     significant(100. * worst.beyond->probability, 3) + " % of the lives");
    const Limits& given = check.demand ? limits : none;
    const Check held = limit ? held_to(check, given, limit) : at_least_as(check, {});
    list.push_back(routed(check.demand ? held : not_checked(held, "nothing acts that way"), lives.law));
  };
  using M = FailureMode;
  add(M::slip_circles, "slip circles", lives.ways->circles, "circles", &Limits::circles);
  add(M::sliding, "friction over F_T", lives.ways->sliding, "sliding_factor", nullptr);
  add(M::sliding_seaward, "friction over F_T seaward", lives.ways->sliding_seaward, "sliding_factor_seaward", nullptr);
}

void add_lives(const MonteCarlo& lives, const std::string& key, const Limits& limits, Checks& list) {
  add_share(lives, key, limits, list);
  add_ways(lives, key, limits, list);
  if (!lives.base) return;
  const BaseOfLives& base = *lives.base;
  const WorstBase of_half{median(base.heel_pressure), median(base.toe_pressure), 0., median(base.overturning_margin)};
  add_base({"of the median life", key + ".base", "the median of all lives, of the worst of each", lives.law}, of_half,
           limits, list);
}

Check distance_check(const std::string& name, const Headline& headline, const std::string& measure,
                     const Limits& limits) {
  return routed(held_to(check_of(FailureMode::sliding_distance, name, "m", headline.value, measure, headline.why),
                        limits, &Limits::sliding),
                headline.law);
}

void add_record(const ExpectedAnswer& answer, const Limits& limits, Checks& list) {
  list.push_back(distance_check("expected sliding distance", headline_of(answer), "expected.headline.value", limits));
  const std::string assumption = "the height that one wave of a sea state exceeds; the worst of all sea states";
  add_base({"highest wave", "expected.base.goda", assumption, Law::exact}, answer.base.goda, limits, list);
  if (answer.base.dynamic)
    add_base({"highest wave", "expected.base.dynamic", assumption, Law::dynamic}, *answer.base.dynamic, limits, list);
}

/// Warnings table_not_used: what is forgotten, where nothing would draw its numbers or send its force.
void add_unused(const Design& design, NumberedWarnings& list) {
  const DesignTables& t = design.tables;
  const auto add = [&](const std::string& what, const std::string& needs, const std::string& cure) {
    list.push_back(
        {"table_not_used", 1., 0., "1", what + " changes nothing: the file has no table [" + needs + "]", cure});
  };
  const auto& scatters = named_scatters();
  if (!t.life &&
      std::any_of(scatters.begin(), scatters.end(), [&](const auto& named) { return t.scatter.*named.table; }))
    add("[scatter]", "life", "give [life], whose lives draw it, or remove [scatter]");
  if (!t.dynamics && t.impact.force == ImpactForce::proverbs)
    add("[impact] force = \"proverbs\"", "dynamics", "give [dynamics] model, which the impact is sent through");
}

/// Warns of sea states at the wall that no sea in deep water can cause.
void add_impossible_seas(const std::vector<StateAnswer>& states, NumberedWarnings& list) {
  const auto impossible = [](const StateAnswer& s) { return !s.before.reaches; };
  const auto first = std::find_if(states.begin(), states.end(), impossible);
  if (first == states.end()) return;
  const DesignHeights& most = first->before.heights;
  list.push_back(
      {"sea_impossible", first->state.significant_height, most.significant, "m",
       std::to_string(std::count_if(states.begin(), states.end(), impossible)) + " of " +
           std::to_string(states.size()) + " sea states have an H_1/3 that no sea brings to that depth, the first " +
           significant(first->state.significant_height, 4) + " m at T = " + significant(first->state.period, 4) +
           " s, where the steepest sea has " + significant(most.significant, 4) + " m" +
           (std::isfinite(most.breaker)
                ? " and breaks at " + significant(most.breaker, 4) + " m, which limits its waves"
                : ""),
       "check significant_height (at the wall), period and water_depth",
       std::any_of(states.begin(), states.end(), [&](const StateAnswer& s) {
         return impossible(s) && s.state.significant_height > mistaken * s.before.heights.significant;
       })});
}

/// Whether numbers of waves are shares of the time, parts of 1 or of 100, or none.
bool are_shares(double sum) {
  constexpr double rounded = 0.01;
  return std::abs(sum - 1.) <= rounded || std::abs(sum - 100.) <= 100. * rounded || sum == 0.;
}

/// Warns where the waves are hardly numbers of waves: shares or percent of the time, whose sum is rounded, or more than
/// its years hold.
void add_doubtful_numbers(double years, const ExpectedAnswer& answer, NumberedWarnings& list) {
  constexpr double percent = 101., year = 365.25 * 86400.;
  constexpr double of_mean = 1.25;  // T_1/3 is up to that many mean periods: Goda (2000)
  double seconds = 0.;
  for (const StateAnswer& s : answer.states) seconds += s.state.waves * s.state.period;
  if (answer.all <= percent)
    list.push_back({"few_waves", answer.all, percent, "1",
                    "all sea states together have " + significant(answer.all, 4) + " waves in " +
                        significant(years, 4) + " years: a share of the time is no number of waves",
                    "give how many waves each row stands for: its share, times years over the mean period",
                    are_shares(answer.all)});
  if (const double longest = of_mean * years; seconds > longest * year)
    list.push_back({"too_many_waves", seconds / year, longest, "years",
                    "the waves of all sea states last " + significant(seconds / year, 4) + " years, longer than the " +
                        significant(years, 4) + " years of the record",
                    "check waves, period and years"});
}

/// Warns of waves that the depth would break, where only a cut or nothing limits the heights.
void add_unbroken_waves(const HighestWave& highest, const ExpectedAnswer& answer, NumberedWarnings& list) {
  if (highest.breaking) return;
  double higher = 0., lowest = HUGE_VAL;
  for (const StateAnswer& s : answer.states) {
    higher += s.state.waves * s.heights.exceedance(s.before.heights.breaker);
    lowest = std::min(lowest, s.before.heights.breaker);
  }
  if (higher < 1.) return;
  list.push_back({"waves_unbroken", higher, 1., "1",
                  some_of(higher, answer.all) + " are higher than Goda's highest breaker, " + significant(lowest, 4) +
                      " m or more by sea state: such waves break before",
                  "write sea.highest = \"breaking\", which limits them"});
}

void add_few_lives(const MonteCarlo& lives, NumberedWarnings& list) {
  const LifeStatistics& s = lives.statistics;
  if (s.sliding_lives >= few_lives) return;
  list.push_back({"few_lives", static_cast<double>(s.sliding_lives), static_cast<double>(few_lives), "1",
                  "only " + std::to_string(s.sliding_lives) + " of " + std::to_string(lives.sliding.size()) +
                      " lives slide by the law " + word(lives.law) + ": mean and interval rest on few of them",
                  "simulate more with --set life.simulated_lives=NUMBER"});
}

std::string share_text(double share) {
  return significant(100. * share, 3) + " %";
}

/// Warns where some of the lives pass a limit, however good the others are.
void add_beyond(const MonteCarlo& lives, const Limits& limits, NumberedWarnings& list) {
  std::vector<std::string> parts;
  double most = 0.;
  const auto add = [&](const Exceeded& e, const std::string& what, const std::string& limit) {
    if (e.probability <= 0.) return;
    most = std::max(most, e.probability);
    parts.push_back(share_text(e.probability) + " of the lives " + what + " " + limit);
  };
  for (const Exceeded& e : lives.statistics.exceeded)
    if (limits.sliding && e.limit == *limits.sliding && !limits.lives_beyond)
      add(e, "slide farther than", with_unit(e.limit, "m"));
  if (lives.base) {
    const std::string motion = lives.law == Law::dynamic ? " in motion" : "";
    const BaseOfLives& base = *lives.base;
    if (const auto& e = base.heel_pressure.beyond)
      add(*e, "have a heel pressure" + motion + " above", with_unit(e->limit, "Pa"));
    if (const auto& e = base.toe_pressure.beyond)
      add(*e, "have a toe pressure" + motion + " above", with_unit(e->limit, "Pa"));
    if (const auto& e = base.overturning_margin.beyond)
      add(*e, "have a margin against overturning" + motion + " below", significant(e->limit));
  }
  if (lives.ways && limits.circles)
    add(*lives.ways->circles.beyond, "have slip circles in motion below", significant(*limits.circles));
  if (parts.empty()) return;
  list.push_back({"lives_beyond_limit", most, 0., "1",
                  "by the law " + std::string(word(lives.law)) + " " + join(parts, "; ") +
                      ": [limits] names no such share that is allowed",
                  "look whether that share is tolerable for the use of the breakwater"});
}

/// Warns where one route is within the limit of S and the other is not.
void add_routes(double by_formulas, double by_dynamics, const std::string& what, const Limits& limits,
                NumberedWarnings& list) {
  if (!limits.sliding || (by_formulas <= *limits.sliding) == (by_dynamics <= *limits.sliding)) return;
  list.push_back({"routes_differ", by_formulas, by_dynamics, "m",
                  what + " is " + with_unit(by_formulas, "m") + " by formulas and " + with_unit(by_dynamics, "m") +
                      " by the caisson's own dynamics, on either side of limits.sliding = " +
                      with_unit(*limits.sliding, "m") + ": two routes to one answer, of which the larger governs",
                  "look at the peak of the impact (peak_gain), its duration, the ground and mu before one of them is "
                  "believed"});
}

/// Warning would_lift: an edge of the base, which the reduced model has bonded, is in tension in the highest wave.
void add_lift(const ExpectedAnswer& answer, NumberedWarnings& list) {
  if (answer.nodes || !answer.base.dynamic || !(answer.base.dynamic->edge_stress < 0.)) return;
  const double stress = answer.base.dynamic->edge_stress;
  list.push_back({"would_lift", stress, 0., "Pa",
                  "in the highest wave of a sea state an edge of the base lifts: bonded, as in the model, it bears a "
                  "tension of up to " +
                      with_unit(-stress, "Pa") +
                      ", which a real base does not, and S, pressures and margins of the law dynamic know nothing of",
                  "solve such a wave by 'upbead run' with [regions.caisson.interface] kind = \"friction\""});
}

/// Warns where nodes slip farther than a block, where some waves have no answer, and where there is none at all.
void add_nodes(const ExpectedAnswer& answer, NumberedWarnings& list) {
  constexpr double alike = 1.05, doubtful = 0.2;
  const int untold = answer.nodes ? answer.nodes->unanswered : 0;
  if (!answer.why_no_nodes.empty() || untold > 0)
    list.push_back({"no_contact", static_cast<double>(untold), 0., "1",
                    answer.nodes ? std::to_string(untold) + " of " + std::to_string(untold + answer.nodes->waves) +
                                       " waves have no S node by node; the largest ratio of the others to that of a "
                                       "block was taken for them"
                                 : "S with slip and lift node by node is not known: " + answer.why_no_nodes,
                    "solve such a wave by 'upbead run', which marches the whole ground"});
  if (!answer.nodes) return;
  const NodeSliding& nodes = *answer.nodes;
  const std::string range =
      "95 % interval " + with_unit(nodes.interval[0], "m") + " to " + with_unit(nodes.interval[1], "m");
  if (nodes.mean > alike * nodes.block)
    list.push_back({"nodes_slide_farther", nodes.mean, nodes.block, "m",
                    "with slip and lift node by node the caisson slides " + with_unit(nodes.mean, "m") + " (" + range +
                        "), as a block " + with_unit(nodes.block, "m") +
                        ": the larger governs; shares and quantiles of lives are of the block",
                    "read shares and quantiles of lives as too small"});
  else if (nodes.draw_error > doubtful * nodes.mean && nodes.interval[1] > alike * nodes.block)
    list.push_back(
        {"few_node_waves", nodes.draw_error, doubtful * nodes.mean, "m",
         "S with slip and lift node by node, " + with_unit(nodes.mean, "m") + ", rests on few waves: " + range,
         "answer more with --set dynamics.node_waves=NUMBER"});
}

/// Warns where the given peak of an impact is below Goda's P in the highest wave of the record.
void add_below_goda(const Design& design, const ExpectedAnswer& answer, NumberedWarnings& list) {
  const auto& gain = design.tables.impact.peak_gain;
  if (!gain || !answer.model || answer.states.empty()) return;
  const DesignTables& t = design.tables;
  const auto highest = std::max_element(answer.states.begin(), answer.states.end(),
                                        [](const auto& a, const auto& b) { return a.base.height < b.base.height; });
  const WaveForces forces({t.section, t.water, t.duration, t.combined}, highest->state);
  const double height = highest->base.height, goda = forces.at(height, {}).force;
  const WavePressure standing = forces.at(height, {}, PressureFormula::standing);
  const double peak = standing.force * (1. + *gain * standing.alpha_star);
  if (peak >= (1. - 1e-9) * goda) return;
  list.push_back({"impact_below_goda", peak, goda, "N/m",
                  "impact.peak_gain = " + significant(*gain) + " gives the highest wave, " + significant(height, 4) +
                      " m, a peak of " + with_unit(peak, "N/m") + ", below P of Goda's formulas, " +
                      with_unit(goda, "N/m") +
                      ", which already is an effective sliding force: the law dynamic is on the unsafe side of the "
                      "formulas",
                  "leave peak_gain out, or give a larger one"});
}

/// Warns of levels of [levels] that no sea of the design has.
NumberedWarnings warnings_of_levels(const DesignTables& tables, const std::vector<StateAnswer>& states) {
  double low = 0., high = 0.;
  if (tables.storms) {
    low = std::min(low, tables.storms->tide_low);
    high = std::max(high, tables.storms->tide_high);
  }
  for (const StateAnswer& answer : states) {
    low = std::min(low, answer.state.water_level);
    high = std::max(high, answer.state.water_level);
  }
  std::vector<std::string> names;
  for (const auto& [name, rise] : tables.levels)
    if (rise < low || rise > high) names.push_back(name);
  return levels_not_used(names.size(),
                         "distances and lives are those of seas from " + significant(low) + " to " + significant(high) +
                             " m above the still water of [section], not at " + join(names) + " of [levels]",
                         "give sea states a water_level, or [storms] tide_low and tide_high");
}

}  // namespace

namespace {

Headline of_laws(const std::map<Law, Expectation>& laws) {
  Headline headline;
  std::string others;
  for (const auto& [law, found] : laws)
    if (headline.why.empty() || found.distance > headline.value) {
      headline.value = found.distance;
      headline.law = law;
      headline.why = "the largest of all laws";
    }
  for (const auto& [law, found] : laws)
    if (law != headline.law) others += (others.empty() ? ": " : ", ") + told(law, found.distance);
  headline.why += others;
  return headline;
}

Headline of_lives(const MonteCarlo& lives, const std::optional<MonteCarlo>& by_formulas) {
  if (!by_formulas)
    return {lives.statistics.mean, lives.law, "the mean of all lives, by the one law that was asked for"};
  const bool first = lives.statistics.mean >= by_formulas->statistics.mean;
  const MonteCarlo &larger = first ? lives : *by_formulas, &other = first ? *by_formulas : lives;
  return {larger.statistics.mean, larger.law,
          "the mean of all lives, the larger of two routes: " + told(other.law, other.statistics.mean)};
}

/// S with slip and lift node by node, where it is larger.
Headline or_of_nodes(Headline first, const std::optional<NodeSliding>& nodes, bool of_lives) {
  if (!nodes || nodes->of_lives != of_lives || nodes->mean <= first.value) return first;
  return {nodes->mean, Law::dynamic,
          "slip and lift node by node, larger than as a block: " + told(first.law, first.value)};
}

}  // namespace

Headline headline_of(const ExpectedAnswer& answer) {
  return or_of_nodes(of_laws(answer.total), answer.nodes, false);
}

Headline headline_of_life(const ExpectedAnswer& answer) {
  return or_of_nodes(of_lives(*answer.monte_carlo, answer.formula_lives), answer.nodes, true);
}

namespace {

/// A limit of lives that has no lives, or no distance, is told to be unchecked.
void add_unjudged(const ExpectedAnswer& answer, const Limits& limits, Checks& list) {
  if (!limits.lives_beyond || (answer.monte_carlo && limits.sliding)) return;
  const Check check = check_of(FailureMode::sliding_distance, "share of lives that slide farther than a limit", "", {},
                               "limits.lives_beyond", "");
  list.push_back(routed(not_checked(held_to(check, limits, &Limits::lives_beyond),
                                    limits.sliding ? "the file simulates no lives: it has no table [life]"
                                                   : "limits.sliding, how far they may slide, is not given"),
                        Law::exact));
}

}  // namespace

Checks checks_of(const Design& design, const ExpectedAnswer& answer) {
  const Limits& limits = design.tables.limits;
  Checks list;
  if (!answer.states.empty()) add_record(answer, limits, list);
  add_unjudged(answer, limits, list);
  if (!answer.monte_carlo) return list;
  list.push_back(
      distance_check("sliding distance of a life", headline_of_life(answer), "monte_carlo.headline.value", limits));
  add_lives(*answer.monte_carlo, "monte_carlo", limits, list);
  if (answer.formula_lives) add_lives(*answer.formula_lives, "monte_carlo.by_formulas", limits, list);
  return list;
}

NumberedWarnings warnings_of(const Design& design, const ExpectedAnswer& answer) {
  NumberedWarnings list = answer.notes.warnings;
  append(list, design.implausible);
  append(list, section_warnings(design.tables.section, design.tables.water));
  add_unused(design, list);
  if (answer.model) append(list, answer.model->warnings);
  append(list, factor_warnings(checks_of(design, answer), design.tables.limits));
  append(list, warnings_of_levels(design.tables, answer.states));
  const Limits& limits = design.tables.limits;
  if (design.tables.sea) {
    add_impossible_seas(answer.states, list);
    add_doubtful_numbers(design.tables.sea->years, answer, list);
    add_unbroken_waves(design.tables.sea->highest, answer, list);
    add_below_goda(design, answer, list);
  }
  if (const auto dynamic = answer.total.find(Law::dynamic); dynamic != answer.total.end())
    add_routes(answer.total.at(Law::exact).distance, dynamic->second.distance, "the expected distance", limits, list);
  add_lift(answer, list);
  add_nodes(answer, list);
  for (const auto* lives : {&answer.monte_carlo, &answer.formula_lives})
    if (*lives) {
      add_few_lives(**lives, list);
      add_beyond(**lives, limits, list);
    }
  if (answer.formula_lives)
    add_routes(answer.formula_lives->statistics.mean, answer.monte_carlo->statistics.mean, "the mean S of a life",
               limits, list);
  return list;
}

}  // namespace upbead
