#include "design/waves_report.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/text.h"
#include "case/formula_checks.h"
#include "output/limits.h"
#include "output/output_text.h"
#include "upbead/sliding/combined.h"

namespace upbead {

namespace {

/// Sets F_Smax = F_T + mu U. F_T is either P of Goda's formula with alpha_I, which already is an effective sliding
/// force, or the measured P times F_T/P.
void set_pulse(const WaveTable& table, const DesignTables& design, WaveAnswer& a) {
  const Section& s = design.section;
  a.measured = table.force.has_value();
  a.force = a.measured ? *table.force * table.shear_to_force_ratio.value_or(1.) : a.pressure.force;
  a.uplift = table.uplift.value_or(a.pressure.uplift);
  a.tau_0F = standing_duration(a.wave.height, s.water_depth, a.wave.period);
  a.k = design.duration(a.pressure.alpha_star);
  a.pulse = {a.force + s.friction * a.uplift, a.k * a.tau_0F};
  a.ratio = a.pulse.peak / a.stability.resistance;
}

void set_sliding(const DesignTables& design, double standing_force, WaveAnswer& a) {
  const Section& s = design.section;
  const double mass = s.weight / design.water.gravity, resistance = a.stability.resistance;
  a.sliding.paper = sliding_distance_paper(mass, resistance, a.pulse);
  a.sliding.paper_parts = sliding_distance_paper_parts(mass, resistance, a.pulse);
  a.sliding.exact = sliding_distance_exact(mass, resistance, a.pulse);
  // a given force is the peak of P, which its standing part does not exceed
  const double standing = a.measured ? std::min(standing_force, a.force) : standing_force;
  const CombinedWave combined{a.wave.period, standing, {a.force, a.pulse.duration}, a.uplift};
  a.sliding.combined =
      sliding_distance_combined(mass + added_mass(design.water.density, s.foundation_depth, design.combined),
                                resistance, s.friction, combined, design.combined);
}

/// Slides the caisson on elastic ground, with resistance mu (W' - U), under P as a triangle; U stays at its peak.
void set_elastic(const WaveTable& table, const DesignTables& design, WaveAnswer& a) {
  if (!design.ground || !table.pulse_duration) return;
  const Section& s = design.section;
  const double resistance = a.stability.resistance - s.friction * a.uplift;
  if (resistance <= 0.) return;  // the caisson floats, as a warning says
  a.elastic = slide_on_base(s.weight / design.water.gravity, *design.ground,
                            history({*table.force, *table.pulse_duration}), resistance);
}

/// Standing waves that have been found, by depth and period: the next higher one starts from there.
using StandingStarts = std::map<std::pair<double, double>, StandingWave>;

StandingResult standing_from(StandingStarts& starts, const Section& section, const Water& water,
                             const DesignWave& wave) {
  const std::pair key(section.water_depth, wave.period);
  const auto lower = starts.find(key);
  StandingResult found = standing_answer(section, water, wave, 1., lower == starts.end() ? nullptr : &lower->second);
  if (found.answer) starts.insert_or_assign(key, found.answer->wave);
  return found;
}

WaveAnswer answer(const std::string& name, const WaveTable& table, const DesignTables& design, StandingStarts& starts) {
  WaveAnswer a;
  a.name = name;
  a.section = design.section;
  a.angle = turned_angle(table, design.section);
  a.direction = table.direction;
  a.direction_words = direction_text(table, design.section);
  a.wave = design_wave(table, design.section, design.water);
  const Goda goda(design.section, design.water, a.wave);
  a.wavelength = goda.wavelength();
  a.pressure = goda.at(a.wave.height);
  a.without_alpha_I = goda.at(a.wave.height, PressureFormula::goda);
  a.stability = stability(design.section, a.pressure, still_water(design.section, design.water));
  set_pulse(table, design, a);
  set_sliding(design, goda.at(a.wave.height, PressureFormula::standing).force, a);
  set_elastic(table, design, a);
  a.standing = standing_from(starts, design.section, design.water, a.wave);
  if (design.impact.proverbs)
    a.impact = breaking_impact(*design.impact.proverbs, design.section, design.water, a.wave, a.wavelength);
  a.warnings = warnings(design.section, design.water, a.wave, a.pressure);
  append(a.warnings, beyond_limits(design.limits, a));
  return a;
}

/// The wave at each level, with the level's height by random breaking, W' and depths of the mound.
std::vector<WaveAnswer> at_levels(const WaveAnswer& own, const WaveTable& table, const DesignTables& design,
                                  StandingStarts& starts) {
  std::vector<WaveAnswer> answers;
  for (const WaterLevel& level : water_levels(design)) {
    DesignTables there = design;
    there.section = at_water_level(design.section, design.water, level.rise);
    answers.push_back(level.rise == 0. ? own : answer(own.name, table, there, starts));
    answers.back().level = level.name;
    answers.back().rise = level.rise;
  }
  return answers;
}

std::string short_number(double value) {
  return significant(value, 4);
}

/// A line on still water at two levels; nothing where it has one.
std::string harbour_text(const Section& s, const Water& water) {
  if (s.harbour_level == 0.) return "";
  const StillWater still = still_water(s, water);
  return "harbour     " + short_number(s.harbour_level) + " m above the sea: push " + short_number(still.push / 1e3) +
         " kN/m landward, W' " + short_number(still.weight / 1e3) + " kN/m more; a push against the wave is left out\n";
}

std::string text_of(const Section& s, const Water& water) {
  return "section     h " + short_number(s.water_depth) + " m, h' " + short_number(s.foundation_depth) + " m, d " +
         short_number(s.berm_depth) + " m, h_c " + short_number(s.crest) + " m, B " + short_number(s.width) +
         " m, B_M " + short_number(s.berm_width) + " m, tan(theta) " + short_number(s.bed_slope) + "\n" +
         "caisson     W " + short_number(s.weight / 1e6) + " MN/m" + ", W' " + short_number(s.submerged_weight / 1e6) +
         " MN/m" + ", mu " + short_number(s.friction) +
         (s.dissipating_blocks ? ", behind wave-dissipating blocks" : "") + "\n" + harbour_text(s, water);
}

}  // namespace

std::vector<WaveAnswer> answer_waves(const DesignTables& design) {
  std::vector<WaveAnswer> answers;
  StandingStarts starts;
  for (const auto& [name, table] : design.waves) {
    answers.push_back(answer(name, table, design, starts));
    answers.back().levels = at_levels(answers.back(), table, design, starts);
    if (!design.levels.empty()) answers.back().governing = governing(answers.back().levels);
  }
  return answers;
}

std::string brief(const Design& whole, const std::vector<WaveAnswer>& answers, const Json& summary) {
  const DesignTables& design = whole.tables;
  const std::vector<OutputRow> rows = rows_of_waves();
  const std::vector<TextColumn> columns{{"rise", "rise"},
                                        {"H", "height"},
                                        {"alpha*", "alpha_star"},
                                        {"P", "force"},
                                        {"U", "uplift"},
                                        {"S.F. sliding", "safety_sliding"},
                                        {"overturning", "safety_overturning"},
                                        {"p_e", "heel_pressure"},
                                        {"S exact", "sliding_exact"}};
  std::string text = design.title.empty() ? "" : design.title + "\n";
  text += text_of(design.section, design.water);
  for (const WaveAnswer& a : answers) {
    if (!a.direction_words.empty()) text += "direction   " + a.name + ": " + a.direction_words + "\n";
    if (a.impact) text += "impact      " + a.name + ": " + text_of(*design.impact.proverbs, *a.impact) + "\n";
  }
  text += table_of(summary["waves"], rows, "waves.NAME", columns, "wave");
  for (const WaveAnswer& a : answers)
    if (!a.levels.empty())
      text += table_of(summary["waves"][a.name]["levels"], rows, "waves.NAME.levels.LEVEL", columns, a.name + " at");
  Checks checks = checks_of(design, answers);
  append(checks, unjudged_limits(design.limits, checks, false));
  return text + verdict_text(verdict_of(checks, warnings_of(whole, answers)), checks);
}

namespace {

FormulaAnswer formula_answer(const WaveAnswer& a) {
  return {a.name,
          a.level,
          a.stability,
          a.standing,
          larger_sliding(a.sliding.exact, a.sliding.combined),
          "waves." + a.name + (a.level.empty() ? "." : ".levels." + a.level + ".")};
}

/// The checks of one wave at one level.
Checks checks_at(const WaveAnswer& a, const Limits& limits) {
  Checks list = formula_checks(formula_answer(a), limits);
  if (!a.measured) return list;
  Check given = check_of(FailureMode::sliding, "force against friction, given P", "N/m", a.pulse.peak,
                         "waves." + a.name + ".sliding_force", "P as given, times F_T/P, with mu U");
  given.by = "formulas";
  given.wave = a.name;
  given.level = a.level;
  list.insert(list.begin(), at_most(given, a.stability.resistance));
  return list;
}

/// The wave at each of its levels, or at the section's own.
std::vector<const WaveAnswer*> at_all_levels(const WaveAnswer& a) {
  if (a.levels.empty()) return {&a};
  std::vector<const WaveAnswer*> list;
  for (const WaveAnswer& level : a.levels) list.push_back(&level);
  return list;
}

}  // namespace

Checks checks_of(const DesignTables& design, const std::vector<WaveAnswer>& answers) {
  Checks list;
  for (const WaveAnswer& a : answers) {
    std::vector<Checks> levels;
    for (const WaveAnswer* level : at_all_levels(a)) levels.push_back(checks_at(*level, design.limits));
    append(list, worst_of_each(levels));
  }
  return list;
}

NumberedWarnings warnings_of(const Design& design, const std::vector<WaveAnswer>& answers) {
  NumberedWarnings list = design.implausible;
  std::set<std::string> of_section;  // level and text: what is wrong with a section is told of its first wave
  for (const WaveAnswer& a : answers) {
    std::map<std::string, std::string> told;  // by name of the warning, its text at the level before
    for (const WaveAnswer* level : at_all_levels(a))
      for (NumberedWarning warning : level->warnings) {
        if (std::exchange(told[warning.name], warning.text()) == warning.text()) continue;
        if (warning.name == "buoyancy" && !of_section.insert(level->level + warning.text()).second) continue;
        warning.what = "wave " + a.name + (level->level.empty() ? "" : " at " + level->level) + ": " + warning.what;
        list.push_back(std::move(warning));
      }
  }
  append(list, factor_warnings(checks_of(design.tables, answers), design.tables.limits));
  return list;
}

}  // namespace upbead
