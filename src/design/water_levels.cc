#include "design/water_levels.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/waves_report.h"
#include "sliding/still_water_push.h"
#include "upbead/waves/edge_pressures.h"

namespace upbead {

namespace {

constexpr double shallowest = 1e-3;  // m, as formula_length()

}  // namespace

Diagnostic misfit(const WaterLevel& level, const Section& section, const Water& water) {
  const Section there = at_water_level(section, water, level.rise);
  const std::string what = level.name + " = " + significant(level.rise, 6) + " m: ";
  const double depth = std::min({section.water_depth, section.foundation_depth, section.berm_depth});
  const std::string between = "give a rise over the section's still water above " + significant(-depth, 6) +
                              " m and of at most " + significant(section.crest, 6) + " m";
  if (level.name == level_of_section)
    return {{}, "'" + level.name + "' is the name of the section's own level, 0 m", "give the level another name"};
  if (depth + level.rise < shallowest)
    return {{}, what + "still water would fall to the seabed, the mound's armour or the caisson's bottom", between};
  if (there.crest < 0.) return {{}, what + "still water would rise above the crest", between};
  if (there.submerged_weight <= 0.)
    return {{},
            what + "the caisson would float, W' = " + significant(there.submerged_weight, 4) + " N/m",
            "give a lower level, or check submerged_weight"};
  return {};
}

namespace {

/// The section at each level, and its own, with words that follow what is wrong there.
std::vector<std::pair<std::string, Section>> sections_at_levels(const DesignTables& tables) {
  std::vector<std::pair<std::string, Section>> list{{"", tables.section}};
  for (const auto& [name, rise] : tables.levels)
    list.emplace_back(" at levels." + name, at_water_level(tables.section, tables.water, rise));
  return list;
}

/// A caisson that the still water of sea and harbour pushes away or lifts has no S of a wave.
Diagnostic pushed_away(const DesignTables& tables) {
  for (const auto& [where, section] : sections_at_levels(tables)) {
    const std::string why =
        moved_by_still_water(still_water(section, tables.water), section.friction, section.submerged_weight, where);
    if (why.empty()) continue;
    return {at_key("harbour_level"), "harbour_level = " + significant(section.harbour_level, 6) + " m: " + why,
            "give the harbour a level nearer to the sea's, or check friction, submerged_weight and width"};
  }
  return {};
}

/// Only lambda_1 = 0 can leave a wave no pressure, where alpha* is 0 or lambda_2 is.
Diagnostic without_pressure(const DesignTables& tables) {
  for (const auto& [where, section] : sections_at_levels(tables))
    for (const auto& [name, given] : tables.waves) {
      const DesignWave wave = design_wave(given, section, tables.water);
      const WavePressure pressure = Goda(section, tables.water, wave).at(wave.height);
      if (pressure.force > 0.) continue;
      return {at_key("lambda_1"),
              "lambda_1 = " + significant(pressure.lambda_1, 6) + " leaves the wave '" + name + "'" + where +
                  " no force on the wall, P = 0, and its factors of safety have no value",
              "give lambda_1 above 0, or lambda_2 above 0 where alpha* is"};
    }
  return {};
}

/// The level that is worst by `worse(a, b)`, the first of equal ones.
template <class Worse, class Value>
GoverningLevel worst_level(const std::vector<WaveAnswer>& levels, Worse worse, Value value) {
  const auto most = std::min_element(levels.begin(), levels.end(), worse);
  return {most->level, value(*most)};
}

/// An order in which the worse comes first; of several levels at which the caisson overturns, that with the least
/// safety.
std::pair<double, double> heel_before(const Stability& s) {
  return {-above_all(s.heel_pressure), s.safety_overturning};
}

template <class Value>
GoverningLevel least(const std::vector<WaveAnswer>& levels, Value value) {
  return worst_level(
      levels, [value](const WaveAnswer& a, const WaveAnswer& b) { return value(a) < value(b); }, value);
}

}  // namespace

const char* const level_of_section = "section";

std::vector<WaterLevel> water_levels(const DesignTables& design) {
  if (design.levels.empty()) return {};
  std::vector<WaterLevel> levels{{level_of_section, 0.}};
  for (const auto& [name, rise] : design.levels) levels.push_back({name, rise});
  std::stable_sort(levels.begin(), levels.end(),
                   [](const WaterLevel& a, const WaterLevel& b) { return a.rise > b.rise; });
  return levels;
}

void check_water_levels(const DesignTables& tables, const Document& document, Diagnostics& report) {
  for (const char* table : {"levels", "section", "fluid", "gravity"})
    if (!report.sound(table)) return;
  for (const auto& [name, rise] : tables.levels)
    if (const Diagnostic wrong = misfit({name, rise}, tables.section, tables.water); !wrong.what.empty())
      report.add(document.place(dotted("levels", name)), "[levels]: " + wrong.what, wrong.cure);
}

void check_what_acts(const DesignTables& tables, const Document& document, Diagnostics& report) {
  for (const char* table : {"levels", "section", "fluid", "gravity", "waves"})
    if (!report.sound(table)) return;
  if (!document.find("section")) return;
  for (const Diagnostic& wrong : {pushed_away(tables), without_pressure(tables)})
    if (!wrong.what.empty())
      report.add(document.place(dotted("section", wrong.place.key)), "[section]: " + wrong.what, wrong.cure);
}

GoverningLevels governing(const std::vector<WaveAnswer>& levels) {
  GoverningLevels worst;
  worst.safety_sliding = least(levels, [](const WaveAnswer& a) { return a.stability.safety_sliding; });
  worst.safety_overturning = least(levels, [](const WaveAnswer& a) { return a.stability.safety_overturning; });
  worst.heel_pressure = worst_level(
      levels,
      [](const WaveAnswer& a, const WaveAnswer& b) { return heel_before(a.stability) < heel_before(b.stability); },
      [](const WaveAnswer& a) { return a.stability.heel_pressure; });
  worst.seaward = least(levels, [](const WaveAnswer& a) { return a.standing.seaward().safety_sliding; });
  return worst;
}

NumberedWarnings beyond_limits(const Limits& limits, const WaveAnswer& a) {
  std::vector<std::pair<std::string, Stability>> checked{{"under the heel", a.stability}};
  if (const auto& standing = a.standing.answer) {
    checked.emplace_back("under the heel, of the standing wave,", standing->landward);
    checked.emplace_back("under the toe, of the standing wave's trough,", standing->seaward);
  }
  const auto heaviest = std::max_element(checked.begin(), checked.end(), [](const auto& x, const auto& y) {
    return above_all(x.second.heel_pressure) < above_all(y.second.heel_pressure);
  });
  const auto loosest = std::min_element(checked.begin(), checked.end(), [](const auto& x, const auto& y) {
    return x.second.safety_overturning < y.second.safety_overturning;
  });
  NumberedWarnings list;
  const auto& most = limits.base_pressure;  // a pressure that does not exist exceeds every limit
  if (const Stability& s = heaviest->second; most && above_all(s.heel_pressure) > *most) {
    list.push_back({"base_pressure", s.heel_pressure.value_or(0.), *limits.base_pressure, s.heel_pressure ? "Pa" : "",
                    "the pressure " + heaviest->first + " is " +
                        (s.heel_pressure ? significant(*s.heel_pressure / 1e3, 4) + " kPa, above"
                                         : "beyond all numbers, as the caisson overturns or floats, and so above") +
                        " limits.base_pressure = " + significant(*limits.base_pressure / 1e3, 4) + " kPa",
                    "widen the caisson, or spread its weight"});
  }
  if (const Stability& s = loosest->second; limits.overturning && s.safety_overturning < *limits.overturning)
    list.push_back({"overturning_limit", s.safety_overturning, *limits.overturning, "1",
                    "the safety factor against overturning is " + significant(s.safety_overturning, 4) +
                        (loosest == checked.begin() ? "" : " in the standing wave") +
                        ", below limits.overturning = " + significant(*limits.overturning, 4),
                    "widen the caisson, or make it heavier"});
  return list;
}

OutputSchema<GoverningLevels> governing_outputs() {
  using G = GoverningLevels;
  const auto level = [](const char* which) {
    return OutputSchema<GoverningLevel>()
        .key("level", &GoverningLevel::level, "", "its name")
        .key("value", &GoverningLevel::value, "", which);
  };
  const auto heel =
      OutputSchema<GoverningLevel>()
          .key("level", &GoverningLevel::level, "", "its name")
          .key("value", &GoverningLevel::value, "Pa", "p_e there; null where the caisson overturns or floats");
  return OutputSchema<G>()
      .object("safety_sliding", &G::safety_sliding, level("the safety factor there"), "least against sliding")
      .object("safety_overturning", &G::safety_overturning, level("the safety factor there"),
              "least against overturning")
      .object("heel_pressure", &G::heel_pressure, heel,
              "largest p_e; a level at which the caisson overturns or floats goes before all others")
      .object("trough_safety_sliding", &G::seaward, level("the safety factor there"),
              "least seaward, of the trough of the standing wave, or of its bound where there is none");
}

}  // namespace upbead
