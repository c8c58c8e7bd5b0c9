#include "design/design.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/text.h"
#include "case/case_checks.h"
#include "design/expected_laws.h"
#include "sliding/still_water_push.h"

namespace upbead {

namespace {

constexpr double least_u = 0x1p-53;  // the least random number of a Stream
constexpr double most_storms = 1e8;  // in one life: minutes

std::string resolved(const Document& document, const std::string& path) {
  return (std::filesystem::path(document.path()).parent_path() / path).lexically_normal().string();
}

/// Reports the mistakes that reading a file may find: at `path` of the report, or at `key`, which names the file,
/// where a mistake has no line.
template <class Read>
void read(const std::string& path, const Place& key, const std::string& file, Diagnostics& report,
          const Read& reading) {
  try {
    reading();
  } catch (const InputError& error) {
    for (const auto& [place, what, cure] : error.diagnostics()) {
      const bool of_the_file = place.line == 0 && !place.file.empty();
      report.add(at_key(path, place.line > 0 ? place : key), (of_the_file ? quoted_path(file) + ": " : "") + what,
                 cure);
    }
  }
}

bool belongs_to_storm(const std::string& name) {
  return name == "significant_height" || name == "period" || name == "water_level";
}

void check_scatter(const NamedScatter& named, const ScatterTables& tables, const Document& document,
                   Diagnostics& report) {
  const std::optional<Scatter>& scatter = tables.*named.table;
  const std::string path = dotted("scatter", named.name);
  if (!scatter || !report.sound(path)) return;
  const TableDiagnostics found(path, document, report);
  const Diagnostics wrong = diagnose(*scatter, named.mean);
  found.add(wrong);
  if (scatter->per == Per::wave && belongs_to_storm(named.name))
    found.add("per", std::string(named.name) + " does not scatter from wave to wave",
              "write per = \"storm\" or \"life\"");
  if (!wrong.empty() || named.mean == 0.) return;
  const double least = Distribution(*scatter, named.mean).quantile(least_u);
  if (least <= 0.)
    found.add("low", "the factor may be " + significant(least) + ", which is not above 0",
              "cut the distribution by low, such as low = 0.2");
}

/// Still water at two levels must leave the caisson where it is, at every level and with the least friction and weight.
void check_push(const DesignTables& tables, const std::vector<double>& levels, double weight, const Place& place,
                Diagnostics& report) {
  const Uncertainties uncertain = uncertainties(tables.scatter);
  const double friction = uncertain.friction ? uncertain.friction->quantile(least_u) : 1.;
  for (const double level : levels) {
    const Section there = with_factors(at_water_level(tables.section, tables.water, level), {1., 1., friction, weight});
    const std::string why =
        moved_by_still_water(still_water(there, tables.water), there.friction, there.submerged_weight,
                             " where the sea stands " + significant(level, 4) + " m above that of [section]");
    if (why.empty()) continue;
    report.add(place, "with harbour_level = " + significant(tables.section.harbour_level, 6) + " m " + why,
               "give the harbour a level nearer to the sea's, or cut [scatter.friction] and [scatter.weight] by low");
    return;
  }
}

/// Still water must stay above the berm and below the crest, and the caisson must not float.
void check_levels(const DesignTables& tables, const std::vector<SeaState>& states, const Document& document,
                  Diagnostics& report) {
  double low = 0., high = 0., weight = 1.;
  if (tables.storms) {
    low = tables.storms->tide_low;
    high = tables.storms->tide_high;
  }
  for (const SeaState& state : states) {
    low = std::min(low, state.water_level);
    high = std::max(high, state.water_level);
  }
  const Uncertainties uncertain = uncertainties(tables.scatter);
  if (uncertain.water_level) {
    low += uncertain.water_level->quantile(least_u);
    high += uncertain.water_level->quantile(1. - least_u);
  }
  if (uncertain.weight) weight = uncertain.weight->quantile(least_u);
  const Place place = at_key("sea", document.place(uncertain.water_level ? "scatter.water_level"
                                                   : tables.storms       ? "storms"
                                                                         : "sea.states"));
  const Section& s = tables.section;
  const double depth = std::min(s.berm_depth, s.foundation_depth);
  if (low <= -depth)
    report.add(place, "still water may fall by " + significant(-low, 4) + " m, below the mound or the caisson",
               "give higher water levels, or cut [scatter.water_level] by low");
  if (high > s.crest)
    report.add(place, "still water may rise by " + significant(high, 4) + " m, above the crest",
               "give lower water levels, or cut [scatter.water_level] by high");
  const Section lightest = with_factors(at_water_level(s, tables.water, high), {1., 1., 1., weight});
  if (high <= s.crest && lightest.submerged_weight <= 0.)
    report.add(uncertain.weight ? at_key("sea", document.place("scatter.weight")) : place,
               "at its least weight and in the highest water the caisson floats",
               "cut [scatter.weight] by low, or [scatter.water_level] by high");
  else if (s.harbour_level != 0. && low > -depth && high <= s.crest)
    check_push(tables, {low, high}, weight, place, report);
}

/// A life must not have more storms than can be computed in reasonable time.
void check_storms(const DesignTables& tables, std::size_t n_states, const Document& document, Diagnostics& report) {
  if (!tables.life || !report.sound("life")) return;
  const double storms = std::ceil(tables.life->years / tables.sea->years) * static_cast<double>(n_states);
  if (storms > most_storms)
    report.add(document.place("life.years"),
               "a life of " + significant(tables.life->years) + " years is the record " +
                   significant(tables.life->years / tables.sea->years) + " times over, " + significant(storms) +
                   " storms, more than " + significant(most_storms),
               "lower life.years, or check sea.years");
}

bool sound_section(const Diagnostics& report) {
  return report.sound("section") && report.sound("gravity") && report.sound("fluid");
}

void check_sea(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (!report.sound("sea")) return;
  if (!tables.sea) {
    if (!tables.storms && report.sound("storms"))
      report.add(document.place("sea"), "the table [sea] is missing, which 'expected' needs",
                 "add [sea] with states = the path of a CSV file, or [storms]");
    return;
  }
  const Place place = document.place("sea.states");
  const std::string file = resolved(document, tables.sea->states);
  read("sea", place, file, report, [&] {
    RecordNotes told_later;
    const std::vector<SeaState> states = read_sea_states(file, place, told_later);
    check_storms(tables, states.size(), document, report);
    if (sound_section(report) && report.sound("scatter")) check_levels(tables, states, document, report);
  });
  for (const auto& [name, height] : tables.sea->heights)
    if (height <= 0.)
      report.add(document.place(dotted("sea.heights", name)), "the height " + significant(height) + " m is not above 0",
                 "give heights above 0 (m)");
}

void check_climate(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (!tables.storms) return;
  const TableDiagnostics found("storms", document, report);
  const StormsTable& storms = *tables.storms;
  if (tables.sea) found.add("", "both [sea] and [storms] are given", "keep one of them");
  if (!tables.life && report.sound("life"))
    found.add("", "[storms] without [life]: there is no life to draw storms for", "add [life] with years and lives");
  if (storms.period && storms.steepness)
    found.add("steepness", "both 'period' and 'steepness' are given", "keep one of them");
  else if (!storms.period && !storms.steepness)
    found.add("", "neither 'period' nor 'steepness' is given", "add one of them");
  if (storms.tide_low > storms.tide_high)
    found.add("tide_low",
              "tide_low = " + significant(storms.tide_low) +
                  " m is above tide_high = " + significant(storms.tide_high) + " m",
              "give tide_low <= tide_high");
  if (tables.life && report.sound("life") && storms.per_year * tables.life->years > most_storms)
    found.add("per_year",
              "a life has " + significant(storms.per_year * tables.life->years) + " storms, more than " +
                  significant(most_storms),
              "lower per_year or life.years");
  if (sound_section(report) && report.sound("scatter") && report.sound("storms"))
    check_levels(tables, {}, document, report);
}

void check_dynamics(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (!report.sound("dynamics")) return;
  if (tables.dynamics && sound_section(report))
    check_model("dynamics", *tables.dynamics, tables.section, tables.water, document, report);
  constexpr int least_nodes = 40;
  if (tables.dynamics && tables.dynamics->node_waves > 0 && tables.dynamics->node_waves < least_nodes)
    report.add(document.place("dynamics.node_waves"),
               "node_waves = " + std::to_string(tables.dynamics->node_waves) + " are too few to tell their error",
               "give at least " + std::to_string(least_nodes) + ", or 0 for none");
  if (!tables.dynamics && tables.life && report.sound("life") && tables.life->sliding == Law::dynamic)
    report.add(document.place("life.sliding"), "sliding = \"dynamic\" needs the caisson's dynamics",
               "add [dynamics] with model = the path of a reduced model, made by 'upbead reduce'");
  check_impact(tables, document, report);
}

}  // namespace

void check_model(const std::string& path, const DynamicsTable& table, const Section& section, const Water& water,
                 const Document& document, Diagnostics& report) {
  const Place place = document.place(dotted(path, "model"));
  const std::string file = resolved(document, table.model);
  read(path, place, file, report, [&] { read_wave_model(file, table, section, water, place); });
}

void check_impact(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (report.sound("impact") && tables.impact.force == ImpactForce::goda_with_alpha_I)
    report.add(
        document.place("impact.force"),
        "Goda's P with alpha_I is no force to send through the caisson's dynamics: alpha_I was fitted to sliding "
        "tests, so this P already is the force that slides, and its dynamic reduction would count twice",
        "write force = \"impulse\"");
}

const std::vector<NamedScatter>& named_scatters() {
  static const std::vector<NamedScatter> list{
      {"significant_height", &ScatterTables::significant_height, &Uncertainties::significant_height, 1.},
      {"wave", &ScatterTables::wave, &Uncertainties::wave, 1.},
      {"period", &ScatterTables::period, &Uncertainties::period, 1.},
      {"force", &ScatterTables::force, &Uncertainties::force, 1.},
      {"uplift", &ScatterTables::uplift, &Uncertainties::uplift, 1.},
      {"friction", &ScatterTables::friction, &Uncertainties::friction, 1.},
      {"weight", &ScatterTables::weight, &Uncertainties::weight, 1.},
      {"water_level", &ScatterTables::water_level, &Uncertainties::water_level, 0.}};
  return list;
}

Uncertainties uncertainties(const ScatterTables& tables) {
  Uncertainties out;
  for (const NamedScatter& named : named_scatters())
    if (tables.*named.table) (out.*named.distribution).emplace(*(tables.*named.table), named.mean);
  return out;
}

void check_expected(const DesignTables& tables, const Document& document, Diagnostics& report) {
  for (const NamedScatter& named : named_scatters()) check_scatter(named, tables.scatter, document, report);
  check_sea(tables, document, report);
  check_climate(tables, document, report);
  check_dynamics(tables, document, report);
}

}  // namespace upbead
