#include "case_checks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/text.h"
#include "case/load_source.h"
#include "case/records/gauge_load.h"
#include "model/exclusions.h"
#include "model/motion.h"
#include "model/words.h"
#include "sliding/still_water_push.h"
#include "upbead/case/case.h"

namespace upbead {

TableDiagnostics::TableDiagnostics(std::string path, const Document& document, Diagnostics& report)
    : path_(std::move(path)), document_(document), report_(report), sound_(report.sound(path_)) {}

void TableDiagnostics::add(const std::string& key, const std::string& what, const std::string& cure) const {
  const std::string path = path_ + "." + key;
  if (sound_ || !document_.find(path)) report_.add(document_.place(path), "[" + path_ + "]: " + what, cure);
}

void TableDiagnostics::add(const Diagnostics& part, const std::string& below) const {
  for (const Diagnostic& found : part) add(below + found.place.key, found.what, found.cure);
}

namespace {
void check_geometry(const std::string& geometry, const Document& document, Diagnostics& report) try {
  const std::vector<std::string> known = geometries();
  if (std::find(known.begin(), known.end(), geometry) == known.end())
    report.add(document.place("mesh.geometry"), "there is no geometry " + in_quotes(geometry),
               suggestion(geometry, known, "geometries"));
} catch (const InputError& error) {
  report.add_at("mesh.geometry", error.diagnostics());
}
}  // namespace

void check_mesh(const CaseTables& tables, const Document& document, Diagnostics& report) {
  if (!report.sound("mesh")) return;
  const MeshChoice& mesh = tables.mesh;
  if (mesh.geometry && mesh.file)
    report.add(document.place("mesh.file"), "both 'geometry' and 'file' are given in [mesh]", "keep one of them");
  else if (mesh.geometry)
    check_geometry(*mesh.geometry, document, report);
  else if (!mesh.file)
    report.add(document.place("mesh"), "neither 'geometry' nor 'file' is given in [mesh]",
               "add geometry = \"composite\", or file = the path of a mesh");
  else if (!mesh.parameters.empty() && std::filesystem::path(*mesh.file).extension() == ".msh")
    report.add(document.place("mesh.parameters"), "'parameters' are those of a .geo, a .msh has none",
               "remove parameters, or give the .geo as file");
}

void check_regions(const CaseTables& tables, const Document& document, Diagnostics& report) {
  if (tables.regions.empty() && report.sound("regions"))
    report.add(document.place("regions"), "the case has no region",
               "add a table [regions.NAME] for every physical surface of the mesh");
  for (const auto& [name, region] : tables.regions) {
    const std::string path = dotted("regions", name);
    if (!report.sound(path + ".kind")) continue;
    TableDiagnostics(path, document, report).add(diagnose(region));
    if (tables.time.inertia || !report.sound("time")) continue;
    for (const Exclusion& reason : excluded(tables, Treatment::consolidation))
      if (reason.key == "regions." + name + ".flow")
        report.add(document.place(dotted(path, "flow")), reason.why, reason.cure);
  }
}

void check_time(const CaseTables& tables, const Document& document, Diagnostics& report) {
  if (!report.sound("time")) return;
  const TimeChoice& time = tables.time;
  if (time.step && document.find("time.end") && *time.step > time.end)
    report.add(document.place("time.step"),
               "step = " + number_text(*time.step) + " is longer than end = " + number_text(time.end),
               "give a shorter step (s), or \"auto\"");
  const std::map<TimeScheme, Treatment> ways{{TimeScheme::reduced, Treatment::reduced_model},
                                             {TimeScheme::generalised_alpha, Treatment::generalised_alpha}};
  const auto way = ways.find(time.scheme);
  if (way == ways.end()) return;
  std::string reasons;
  for (const Exclusion& reason : excluded(tables, way->second)) reasons += (reasons.empty() ? "" : ", ") + reason.why;
  if (!reasons.empty())
    report.add(
        document.place("time.scheme"),
        "scheme = \"" + word_of(time.scheme, time_scheme_words) + "\" cannot do what the case asks for: " + reasons,
        "write scheme = \"auto\"");
}

void check_cycles(const CaseTables& tables, const Document& document, Diagnostics& report) {
  if (tables.cycles_table && report.sound("cycles"))
    TableDiagnostics("cycles", document, report).add(diagnose(*tables.cycles_table));
}

void check_output(const CaseTables& tables, const Document& document, Diagnostics& report) {
  if (!report.sound("output") || !report.sound("time")) return;
  constexpr std::size_t most_times = 10000;
  const std::vector<double>& times = tables.output_times;
  const Place place = document.place("output.times");
  if (times.size() > most_times)
    report.add(place, std::to_string(times.size()) + " times, more than " + std::to_string(most_times),
               "write [output] every, for histories at equal times");
  for (std::size_t i = 0; i < times.size(); ++i)
    if (i > 0 && times[i] <= times[i - 1])
      return report.add(place,
                        "times do not ascend: " + number_text(times[i]) + " follows " + number_text(times[i - 1]),
                        "order them, each once");
  if (!times.empty() && document.find("time.end") && times.back() > tables.time.end)
    report.add(place,
               "times = [..., " + number_text(times.back()) + "] lies after time.end = " + number_text(tables.time.end),
               "give times (s) up to the end, or a later end");
}

void check_probes(const CaseTables& tables, const Document& document, Diagnostics& report) {
  constexpr std::size_t most_probes = 5000;  // with 15 histories each 0.6 GB in 1,000 steps
  if (tables.probes.size() > most_probes)
    report.add(document.place("probes"),
               std::to_string(tables.probes.size()) + " probes; at most " + std::to_string(most_probes) +
                   " are followed, with a history of each of their readings",
               "keep the points that are looked at, or write fields, [output] fields = { every = ... }");
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  for (const auto& [name, probe] : tables.probes) {
    const std::string path = dotted("probes", name);
    if (report.sound(path) && (name.empty() || !std::all_of(name.begin(), name.end(), plain)))
      report.add(document.place(path), "probe " + to_toml(excerpt(name)) + " cannot name a dataset of the results",
                 "use letters, digits, _ and -");
  }
}

namespace {

template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

/// The checks of one load that do not depend on how its course is given.
class LoadChecks {
 public:
  explicit LoadChecks(const LoadCheck& check)
      : load_(check.load), tables_(check.tables), check_(check), wrong_(check.wrong) {}

  void run() const {
    if (is_on_volume(load_.kind))
      check_volume();
    else
      check_.exactly_one("boundary", "region");
    way_of(load_).check(check_);
    if (is_motion(load_.kind)) check_motion();
    if (wrong_.given("boundary") && !is_on_volume(load_.kind))
      check_name("boundary", load_.boundary, keys_of(tables_.boundaries), "boundaries");
    if (wrong_.given("region")) check_region();
    if (has_own_direction(load_) && load_.direction[0] == 0. && load_.direction[1] == 0.)
      wrong_.add("direction", "direction is zero", "give a direction such as [1.0, 0.0]");
    if (!load_.shape.empty()) check_shape();
    if (load_.pulse && check_.report.sound(check_.path + ".pulse.shape")) wrong_.add(diagnose(*load_.pulse), "pulse.");
  }

 private:
  bool check_name(const std::string& key, const std::string& name, const std::vector<std::string>& known,
                  const std::string& kind) const {
    if (std::find(known.begin(), known.end(), name) != known.end()) return true;
    wrong_.add(key, key + " = " + to_toml(name) + " has no table [" + dotted(kind, name) + "]",
               suggestion(name, known, kind));
    return false;
  }

  void check_region() const {
    if (!check_name("region", load_.region, keys_of(tables_.regions), "regions")) return;
    if (is_on_volume(load_.kind)) return;  // the checks of the mesh say which kind the region must be
    if (check_.report.sound(dotted("regions", load_.region)) &&
        tables_.regions.at(load_.region).kind != RegionKind::rigid)
      wrong_.add("region", "region = " + to_toml(load_.region) + " is not rigid",
                 "load one of its boundaries instead; only a rigid region takes a load at a point");
    if (load_.kind != LoadKind::force)
      wrong_.add("kind", "a load on a region is a force, no traction or pressure", "write kind = \"force\"");
  }

  void check_volume() const {
    const std::string kind = word_of(load_.kind, load_kind_words);
    if (wrong_.given("boundary"))
      wrong_.add("boundary", "kind = \"" + kind + "\" acts on the volume of a region",
                 "remove boundary, and give region" +
                     std::string(load_.kind == LoadKind::gravity ? ", or neither for all of them" : ""));
    else if (!wrong_.given("region") && load_.kind != LoadKind::gravity)
      wrong_.add("region", "'region' is missing, which kind = \"" + kind + "\" needs", "add region");
  }

  void check_motion() const {
    if (wrong_.given("region")) wrong_.add("region", "a motion is that of a boundary", "give boundary");
    if (load_.kind == LoadKind::displacement && load_.pulse && diagnose(*load_.pulse).empty() && jumps(*load_.pulse))
      wrong_.add("pulse", "the displacement jumps, at an infinite velocity", "give a rise between 0 and the duration");
    const auto side = tables_.boundaries.find(load_.boundary);
    if (side == tables_.boundaries.end()) return;
    using D = DisplacementCondition;
    const D condition = side->second.displacement;
    if (condition != D::fixed && condition != D::roller && condition != D::absorbing)
      wrong_.add("kind",
                 "the motion of '" + load_.boundary + "' cannot be prescribed, whose displacement is \"" +
                     word_of(condition, displacement_words) + "\"",
                 "say displacement = \"fixed\" or \"roller\" in [" + dotted("boundaries", load_.boundary) +
                     "], or \"absorbing\" for waves that come from below");
  }

  void check_shape() const {
    if (load_.over_x && load_.along_curve)
      wrong_.add("along_curve", "over_x and along_curve are both true", "keep one of them");
    const auto& shape = load_.shape;
    bool ascending = true, all_zero = true;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      ascending = ascending && (i == 0 || shape[i][0] > shape[i - 1][0]);
      all_zero = all_zero && shape[i][1] == 0.;
    }
    if (shape.size() < 2)
      wrong_.add("shape", "one pair of height and intensity makes no shape", "give two pairs or more");
    if (!ascending) wrong_.add("shape", "the heights of shape do not ascend", "order the pairs by height");
    if (all_zero) wrong_.add("shape", "every intensity of shape is zero", "give an intensity other than zero");
  }

  const LoadTable& load_;
  const CaseTables& tables_;
  const LoadCheck& check_;
  const TableDiagnostics& wrong_;
};

}  // namespace

void LoadCheck::exactly_one(const std::string& a, const std::string& b) const {
  if (wrong.given(a) && wrong.given(b)) wrong.add(b, "both '" + a + "' and '" + b + "' are given", "keep one of them");
  if (!wrong.given(a) && !wrong.given(b))
    wrong.add(a, "neither '" + a + "' nor '" + b + "' is given", "add " + a + " or " + b);
}

void LoadCheck::refuse(const std::vector<std::string>& keys, const std::string& what,
                       const std::string& or_else) const {
  for (const std::string& key : keys)
    if (wrong.given(key))
      wrong.add(key, "'" + key + "' does not belong to " + what, "remove " + key + ", or " + or_else);
}

void check_loads(const CaseTables& tables, const Document& document, Diagnostics& report) {
  for (const auto& [name, load] : tables.load_tables)
    if (const std::string path = dotted("loads", name); report.sound(path + ".kind"))
      LoadChecks({path, load, tables, document, report, {path, document, report}}).run();
}

namespace {

/// An uplift of kind "wave" needs exactly one load by a wave.
void check_wave_uplift(const CaseTables& tables, const TableDiagnostics& wrong) {
  std::vector<std::string> names;
  for (const auto& [name, load] : tables.load_tables)
    if (load.kind == LoadKind::wave && load.factor != 0.) names.push_back(name);
  if (names.empty())
    wrong.add("kind", "kind = \"wave\" is the uplift of a load by a wave, and no load that acts has kind = \"wave\"",
              "add one, or write kind = \"prescribed\"");
  else if (names.size() > 1)
    wrong.add("kind", "kind = \"wave\" does not tell which of the loads by waves is meant: " + join(names),
              "switch off all but one by factor = 0");
}

/// A prescribed uplift is given in exactly one way.
void check_prescribed(const UpliftTable& uplift, const TableDiagnostics& wrong) {
  std::vector<std::string> ways;
  if (uplift.peak) ways.emplace_back("peak");
  if (!uplift.history_file.empty()) ways.emplace_back("history");
  if (!uplift.gauges.empty()) ways.emplace_back("gauges");
  if (ways.size() > 1) wrong.add(ways[1], "both '" + ways[0] + "' and '" + ways[1] + "' are given", "keep one of them");
  if (ways.empty())
    wrong.add("peak", "neither 'peak' nor 'history' nor 'gauges' of a prescribed uplift is given", "add one of them");
  if (!uplift.peak && !ways.empty() && uplift.lag > 0.)
    wrong.add("lag", "'lag' is that of an uplift that follows P, a history has its own times", "remove lag");
}

void check_uplift(const UpliftTable& uplift, const CaseTables& tables, const Document& document, Diagnostics& report) {
  const TableDiagnostics wrong("sliding.uplift", document, report);
  if (uplift.kind == UpliftKind::prescribed) check_prescribed(uplift, wrong);
  if (uplift.kind == UpliftKind::wave) check_wave_uplift(tables, wrong);
  if (!uplift.gauges.empty()) {
    check_gauges(uplift, bottom_words, "sliding.uplift", document, report);
    if (!uplift.ends) wrong.add("ends", "it is not said where the bottom ends", "add ends = [seaward, landward] (m)");
  }
  for (const auto& [name, load] : tables.load_tables)
    if (load.wave && !load.wave->mound.empty() && load.factor != 0. && uplift.kind != UpliftKind::computed)
      wrong.add("kind",
                "the load '" + name + "' presses on the mound's pore water, so that a given uplift would count twice",
                "write kind = \"computed\", or remove mound from [" + dotted("loads", name) + ".wave]");
  for (const auto& [name, load] : tables.load_tables)
    if (load.boundary.empty() && load.region == caisson_name && load.direction[1] > 0. && load.factor != 0.)
      wrong.add("kind", "the load '" + name + "' lifts the caisson, so that an uplift would count twice",
                "remove [sliding.uplift] or the upward part of [" + dotted("loads", name) + "]");
}

/// The friction of the frictional contact, node by node, and that of the caisson as a whole must be the same.
void check_contact(const SlidingTable& sliding, const CaseTables& tables, const TableDiagnostics& wrong) {
  const std::optional<double>& mu = tables.regions.at(caisson_name).interface->coefficient;
  if (mu && sliding.own_friction && *mu != *sliding.own_friction)
    wrong.add("friction",
              "friction = " + number_text(*sliding.own_friction) + " is not the coefficient = " + number_text(*mu) +
                  " of [regions.caisson] interface",
              "give the same number, or only one of them");
}

}  // namespace

namespace {

/// The section and [sliding] describe one caisson, so a value given in both must be the same.
void check_same(const std::string& key, const std::optional<double>& given, double of_section,
                const TableDiagnostics& wrong) {
  if (given && *given != of_section)
    wrong.add(key,
              key + " = " + number_text(*given) + " is not that of [section], " + key + " = " + number_text(of_section),
              "give the same number, or only that of [section]");
}

void check_section_of(const SlidingTable& sliding, const CaseTables& tables, const Document& document,
                      const TableDiagnostics& wrong, Diagnostics& report) {
  if (!tables.section) {
    if (!sliding.own_submerged_weight)
      report.add(document.place("sliding"), "'submerged_weight' is missing in [sliding]",
                 "add submerged_weight, a number (N/m)");
    return;
  }
  check_same("friction", sliding.own_friction, tables.section->friction, wrong);
  check_same("submerged_weight", sliding.own_submerged_weight, tables.section->submerged_weight, wrong);
  check_same("weight", sliding.weight, tables.section->weight, wrong);
}

/// Sea and harbour of the section stand as those of [initial] do.
void check_levels_of(const Section& section, const CaseTables& tables, const TableDiagnostics& wrong) {
  constexpr double same_level = 1e-3;  // m
  const auto& initial = tables.initial;
  const bool given = initial && initial->water_level && initial->harbour_level;
  const double rise = given ? *initial->harbour_level - *initial->water_level : 0.;
  if (std::abs(rise - section.harbour_level) > same_level)
    wrong.add("harbour_level",
              "harbour_level = " + number_text(section.harbour_level) +
                  " m above the sea, but in [initial] the harbour " +
                  (given ? "stands " + number_text(rise) + " m above it" : "has no level of its own"),
              "give the same in both: initial.harbour_level = initial.water_level + section.harbour_level");
}

/// A caisson that the still water of sea and harbour pushes away has no S of a wave.
void check_that_it_stays(const Section& section, const Water& water, const TableDiagnostics& wrong) {
  const std::string why = moved_by_still_water(still_water(section, water), section.friction, section.submerged_weight);
  if (why.empty()) return;
  wrong.add("harbour_level", "harbour_level = " + number_text(section.harbour_level) + " m: " + why,
            "give the harbour a level nearer to the sea's, or check friction, submerged_weight and width");
}

}  // namespace

void check_section(const CaseTables& tables, const Document& document, Diagnostics& report) {
  if (!tables.section || !report.sound("section")) return;
  const TableDiagnostics wrong("section", document, report);
  wrong.add(diagnose(*tables.section));
  check_levels_of(*tables.section, tables, wrong);
  check_that_it_stays(*tables.section, {tables.fluid.density, tables.gravity}, wrong);
  if (!report.sound("regions") || !has_frictional_contact(tables)) return;
  const std::optional<double>& mu = tables.regions.at(caisson_name).interface->coefficient;
  if (mu && *mu != tables.section->friction)
    wrong.add("friction",
              "friction = " + number_text(tables.section->friction) + " is not the coefficient = " + number_text(*mu) +
                  " of [regions.caisson] interface",
              "give the same number, or leave the coefficient to the section");
}

void check_sliding(const CaseTables& tables, const Document& document, Diagnostics& report) {
  if (!tables.sliding_table || !report.sound("sliding")) return;
  const SlidingTable& sliding = *tables.sliding_table;
  const TableDiagnostics wrong("sliding", document, report);
  if (sliding.weight && sliding.own_submerged_weight && *sliding.own_submerged_weight > *sliding.weight)
    wrong.add("submerged_weight",
              "submerged_weight = " + number_text(*sliding.own_submerged_weight) +
                  " N/m is above weight = " + number_text(*sliding.weight) + " N/m",
              "give W' in still water, W less the weight of the water that the caisson displaces; of a dry block both "
              "are equal");
  check_section_of(sliding, tables, document, wrong, report);
  if (report.sound("regions") && has_frictional_contact(tables)) check_contact(sliding, tables, wrong);
  if (report.sound("regions") && tables.regions.count(caisson_name) == 0)
    wrong.add("friction", "there is no region 'caisson' that could slide",
              "name the caisson's surface 'caisson', or remove [sliding]");
  if (sliding.uplift_table) return check_uplift(*sliding.uplift_table, tables, document, report);
  for (const auto& [name, load] : tables.load_tables)
    if (load.wave && !load.wave->mound.empty() && load.factor != 0.)
      wrong.add("uplift",
                "the load '" + name +
                    "' lifts the caisson by the mound's pore water, which without a table uplift counts "
                    "in no S of the caisson as a whole",
                "add uplift = { kind = \"computed\" }");
}

}  // namespace upbead
