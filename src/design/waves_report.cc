#include "design/waves_report.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "base/text.h"
#include "case/formula_checks.h"
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

WaveAnswer answer(const std::string& name, const WaveTable& table, const DesignTables& design) {
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
  a.standing = standing_answer(design.section, design.water, a.wave);
  if (design.impact.proverbs)
    a.impact = breaking_impact(*design.impact.proverbs, design.section, design.water, a.wave, a.wavelength);
  a.warnings = warnings(design.section, design.water, a.wave, a.pressure);
  append(a.warnings, beyond_limits(design.limits, a));
  return a;
}

/// The wave at each level, with the level's height by random breaking, W' and depths of the mound.
std::vector<WaveAnswer> at_levels(const WaveAnswer& own, const WaveTable& table, const DesignTables& design) {
  std::vector<WaveAnswer> answers;
  for (const WaterLevel& level : water_levels(design)) {
    DesignTables there = design;
    there.section = at_water_level(design.section, design.water, level.rise);
    answers.push_back(level.rise == 0. ? own : answer(own.name, table, there));
    answers.back().level = level.name;
    answers.back().rise = level.rise;
  }
  return answers;
}

using Row = std::vector<std::string>;

constexpr std::size_t widest_line = 100;

/// The first column, and those from `from` on that fit in a line; the next one that does not.
std::pair<std::string, std::size_t> aligned_from(std::size_t from, const std::vector<Row>& rows,
                                                 const std::vector<std::size_t>& width, std::size_t gap) {
  std::size_t to = from, line = width[0];
  while (to < width.size() && (to == from || line + gap + width[to] <= widest_line)) line += gap + width[to++];
  std::string text;
  for (const Row& row : rows) {
    text += row[0] + std::string(width[0] - row[0].size(), ' ');
    for (std::size_t i = from; i < to; ++i) text += std::string(gap + width[i] - row[i].size(), ' ') + row[i];
    text += "\n";
  }
  return {text, to};
}

/// Columns as wide as needed, the first aligned to the left, all other ones to the right. Those that do not fit in a
/// line, even close together, follow below, after the first one again.
std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> width(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  const std::size_t close = std::accumulate(width.begin(), width.end(), width.size() - 1);
  const bool is_close = close <= widest_line && close + width.size() - 1 > widest_line;
  std::string text;
  for (std::size_t next = 1; next < width.size();) {
    const auto [block, to] = aligned_from(next, rows, width, is_close ? 1 : 2);
    text += (next > 1 ? "\n" : "") + block;
    next = to;
  }
  return text;
}

std::string short_number(double value) {
  return significant(value, 4);
}

Row pressures(const WaveAnswer& a, const Limits&) {
  const WavePressure& p = a.pressure;
  Row row{a.name};
  for (const double value : {a.wave.height, a.wave.significant_height, a.wave.period, a.wavelength, p.alpha_1,
                             p.alpha_2, p.alpha_3, p.alpha_I, p.alpha_star, p.eta_star})
    row.push_back(short_number(value));
  for (const double value : {p.p1, p.p3, p.p4, p.pu}) row.push_back(short_number(value / 1e3));
  return row;
}

/// Explains "!", where it may occur.
std::string note_on(const Limits& limits) {
  return limits.base_pressure || limits.overturning ? ", ! beyond [limits]" : "";
}

std::string judged_overturning(const Stability& s, const Limits& limits) {
  return short_number(s.safety_overturning) + (overturns_too_easily(s, limits) ? "!" : "");
}

Row safety(const WaveAnswer& a, const Limits& limits) {
  return {a.name,
          short_number(a.pressure.force / 1e3),
          short_number(a.pressure.uplift / 1e3),
          short_number(a.pressure.force_moment / 1e6),
          short_number(a.pressure.uplift_moment / 1e6),
          short_number(a.stability.safety_sliding),
          judged_overturning(a.stability, limits),
          judged_heel(a.stability, limits)};
}

Row sliding(const WaveAnswer& a, const Limits&) {
  return {a.name,
          short_number(a.force / 1e3) + (a.measured ? " (given)" : ""),
          short_number(a.pulse.peak / 1e3),
          short_number(a.ratio),
          short_number(a.tau_0F),
          short_number(a.k),
          short_number(a.pulse.duration),
          short_number(a.sliding.paper),
          short_number(a.sliding.exact),
          short_number(a.sliding.combined)};
}

std::string table(const std::string& title, Row head, const std::vector<WaveAnswer>& answers, const Limits& limits,
                  Row (*row)(const WaveAnswer&, const Limits&)) {
  std::vector<Row> rows{std::move(head)};
  for (const WaveAnswer& a : answers) rows.push_back(row(a, limits));
  return "\n" + title + "\n" + aligned(rows);
}

Row at_level(const WaveAnswer& a, const GoverningLevels& worst, const Limits& limits) {
  const auto marked = [&](const std::string& cell, const GoverningLevel& which) {
    return cell + (which.level == a.level ? "*" : "");
  };
  const auto& standing = a.standing.answer;
  return {a.name + " at " + a.level,
          short_number(a.rise),
          short_number(a.section.water_depth),
          short_number(a.wave.height),
          short_number(a.pressure.alpha_star),
          short_number(a.pressure.force / 1e3),
          short_number(a.pressure.uplift / 1e3),
          marked(short_number(a.stability.safety_sliding), worst.safety_sliding),
          marked(judged_overturning(a.stability, limits), worst.safety_overturning),
          marked(judged_heel(a.stability, limits), worst.heel_pressure),
          short_number(a.sliding.exact),
          standing ? short_number(standing->landward.safety_sliding) : "-",
          marked(short_number(a.standing.seaward().safety_sliding) + (standing ? "" : " (bound)"), worst.seaward)};
}

std::string levels_table(const std::vector<WaveAnswer>& answers, const Limits& limits) {
  std::vector<Row> rows{{"wave and level", "rise", "h", "H", "alpha*", "P", "U", "S.F. sliding", "S.F. overturning",
                         "p_e", "S exact", "standing: S.F.", "seaward"}};
  for (const WaveAnswer& a : answers)
    for (const WaveAnswer& level : a.levels) rows.push_back(at_level(level, *a.governing, limits));
  if (rows.size() == 1) return "";
  return "\nWater levels, * the one that governs" + note_on(limits) + " (m, kN/m, kPa)\n" + aligned(rows);
}

/// A table of the waves that stand before the wall, and for those that do not each reason once, with its waves.
std::string standing_table(const std::vector<WaveAnswer>& answers, const Limits& limits) {
  std::vector<Row> rows{standing_head()};
  std::string none;
  for (const WaveAnswer& a : answers) {
    if (a.standing.answer) {
      rows.push_back(standing_row(a.name, *a.standing.answer, limits));
      continue;
    }
    const TroughBound& bound = *a.standing.bound;
    none += a.name + ": " + a.standing.why_not + "; its trough at most: P " + short_number(-bound.force / 1e3) +
            " kN/m, S.F. sliding " + short_number(bound.seaward.safety_sliding) + ", p_toe " +
            judged_heel(bound.seaward, limits) + " kPa (a bound after Sainflou)\n";
  }
  const std::string title =
      "\nStanding wave of finite height, in crest and trough" + note_on(limits) + " (m, kN/m, kPa)\n";
  return title + (rows.size() > 1 ? aligned(rows) : "") + none;
}

/// A line on still water at two levels; nothing where it has one.
std::string harbour_text(const Section& s, const Water& water) {
  if (s.harbour_level == 0.) return "";
  const StillWater still = still_water(s, water);
  return "harbour     " + short_number(s.harbour_level) + " m above the sea: push " + short_number(still.push / 1e3) +
         " kN/m landward, W' " + short_number(still.weight / 1e3) + " kN/m more; a push against the wave is left out\n";
}

/// Impacts by PROVERBS, where the design has them.
std::string impact_table(const std::vector<WaveAnswer>& answers, const DesignTables& design) {
  std::vector<Row> rows{
      {"wave", "H_b", "H", "(h-d)/h", "H_1/3/h", "B_eq/L", "share", "F*", "F", "F median", "F SR 443"}};
  std::string words;
  for (const WaveAnswer& a : answers) {
    if (!a.impact) return "";
    const BreakingImpact& i = *a.impact;
    Row row{a.name};
    for (const double value : {i.breaker, a.wave.height, i.relative_mound, i.relative_height, i.relative_berm, i.share,
                               i.relative_peak, i.peak / 1e3, i.median_peak / 1e3})
      row.push_back(short_number(value));
    row.push_back(i.sr443 ? short_number(*i.sr443 / 1e3) : "-");
    rows.push_back(row);
    words += a.name + ": " + text_of(*design.impact.proverbs, i) + "\n";
  }
  return "\nImpacts by PROVERBS, if the waves break on the wall (m, kN/m)\n" + aligned(rows) + words;
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
  for (const auto& [name, table] : design.waves) {
    answers.push_back(answer(name, table, design));
    answers.back().levels = at_levels(answers.back(), table, design);
    if (!design.levels.empty()) answers.back().governing = governing(answers.back().levels);
  }
  return answers;
}

std::string text_of(const Design& whole, const std::vector<WaveAnswer>& answers) {
  const DesignTables& design = whole.tables;
  std::string text = design.title.empty() ? "" : design.title + "\n";
  text += text_of(design.section, design.water);
  for (const WaveAnswer& a : answers)
    if (!a.direction_words.empty()) text += "direction   " + a.name + ": " + a.direction_words + "\n";
  text += table("Pressure after Goda, with alpha* = max(alpha_2, alpha_I) (m, s, kPa)",
                {"wave", "H", "H_1/3", "T", "L", "alpha_1", "alpha_2", "alpha_3", "alpha_I", "alpha*", "eta*", "p1",
                 "p3", "p4", "pu"},
                answers, design.limits, pressures);
  text += table("Safety" + note_on(design.limits) + " (kN/m, MN m/m, kPa)",
                {"wave", "P", "U", "M_P", "M_U", "S.F. sliding", "S.F. overturning", "p_e"}, answers, design.limits,
                safety);
  text += standing_table(answers, design.limits);
  text += impact_table(answers, design);
  text += levels_table(answers, design.limits);
  text += table("Sliding by tau_0 = k(alpha*) tau_0F (kN/m, s, m)",
                {"wave", "F_T", "F_Smax", "r", "tau_0F", "k", "tau_0", "S eq. (7)", "S exact", "S combined"}, answers,
                design.limits, sliding);
  for (const WaveAnswer& a : answers)
    if (a.elastic)
      text += "\n" + a.name + " on the swaying ground: peak F_T " + short_number(a.elastic->peak_shear / 1e3) +
              " kN/m, peak x " + short_number(a.elastic->peak_displacement) + " m, S " +
              short_number(a.elastic->slip.residual) + " m";
  const Checks checks = checks_of(design, answers);
  return text + (text.back() == '\n' ? "\n" : "\n\n") +
         verdict_text(verdict_of(checks, warnings_of(whole, answers)), checks);
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
  for (const WaveAnswer& a : answers) {
    std::map<std::string, std::string> told;  // by name of the warning, its text at the level before
    for (const WaveAnswer* level : at_all_levels(a))
      for (NumberedWarning warning : level->warnings) {
        if (std::exchange(told[warning.name], warning.text()) == warning.text()) continue;
        warning.what = "wave " + a.name + (level->level.empty() ? "" : " at " + level->level) + ": " + warning.what;
        list.push_back(std::move(warning));
      }
  }
  append(list, factor_warnings(checks_of(design.tables, answers), design.tables.limits));
  return list;
}

}  // namespace upbead
