#include "case_checks.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "base/quoted.h"
#include "model/exclusions.h"
#include "model/words.h"
#include "upbead/case/case.h"

namespace upbead {

Objections::Objections(std::string path, const Document& document, InputReport& report)
    : path_(std::move(path)), document_(document), report_(report), sound_(report.sound(path_)) {}

void Objections::add(const Objection& objection) const {
  const std::string key = path_ + "." + objection.key;
  if (sound_ || !document_.find(key))
    report_.add(path_, document_.place(key), "[" + path_ + "]: " + objection.what, objection.cure);
}

namespace {
void check_geometry(const std::string& geometry, const Document& document, InputReport& report) try {
  const std::vector<std::string> known = geometries();
  if (std::find(known.begin(), known.end(), geometry) == known.end())
    report.add("mesh.geometry", document.place("mesh.geometry"), "there is no geometry " + in_quotes(geometry),
               suggestion(geometry, known, "geometries"));
} catch (const InputError& error) {
  for (const Mistake& mistake : error.mistakes()) report.add("mesh.geometry", mistake);
}
}  // namespace

void check_mesh(const CaseTables& tables, const Document& document, InputReport& report) {
  if (!report.sound("mesh")) return;
  const MeshChoice& mesh = tables.mesh;
  if (mesh.geometry && mesh.file)
    report.add("mesh", document.place("mesh.file"), "both 'geometry' and 'file' are given in [mesh]",
               "keep one of them");
  else if (mesh.geometry)
    check_geometry(*mesh.geometry, document, report);
  else if (!mesh.file)
    report.add("mesh", document.place("mesh"), "neither 'geometry' nor 'file' is given in [mesh]",
               "add geometry = \"composite\", or file = the path of a mesh");
  else if (!mesh.parameters.empty() && std::filesystem::path(*mesh.file).extension() == ".msh")
    report.add("mesh", document.place("mesh.parameters"), "'parameters' are those of a .geo, a .msh has none",
               "remove parameters, or give the .geo as file");
}

void check_regions(const CaseTables& tables, const Document& document, InputReport& report) {
  if (tables.regions.empty() && report.sound("regions"))
    report.add("regions", document.place("regions"), "the case has no region",
               "add a table [regions.NAME] for every physical surface of the mesh");
  for (const auto& [name, region] : tables.regions) {
    const std::string path = dotted("regions", name);
    if (!report.sound(path + ".kind")) continue;
    const Objections objections(path, document, report);
    for (const Objection& objection : check(region)) objections.add(objection);
    if (region.flow == Flow::inertial && report.sound("time") && !tables.time.inertia)
      report.add(path, document.place(dotted(path, "flow")), "flow = \"inertial\" contradicts time.inertia = false",
                 "write flow = \"auto\" or inertia = true");
  }
}

void check_time(const CaseTables& tables, const Document& document, InputReport& report) {
  if (!report.sound("time")) return;
  const TimeChoice& time = tables.time;
  if (time.step && *time.step > time.end)
    report.add("time", document.place("time.step"),
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
        "time", document.place("time.scheme"),
        "scheme = \"" + word_of(time.scheme, time_scheme_words) + "\" cannot do what the case asks for: " + reasons,
        "write scheme = \"auto\"");
}

void check_probes(const CaseTables& tables, const Document& document, InputReport& report) {
  constexpr std::size_t most_probes = 5000;  // with 15 histories each 0.6 GB in 1,000 steps
  if (tables.probes.size() > most_probes)
    report.add("probes", document.place("probes"),
               std::to_string(tables.probes.size()) + " probes; at most " + std::to_string(most_probes) +
                   " are followed, with a history of each of their readings",
               "keep the points that are looked at, or write fields, [output] fields = { every = ... }");
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  for (const auto& [name, probe] : tables.probes) {
    const std::string path = dotted("probes", name);
    if (report.sound(path) && (name.empty() || !std::all_of(name.begin(), name.end(), plain)))
      report.add(path, document.place(path),
                 "probe " + to_toml(excerpt(name)) + " cannot name a dataset of the results",
                 "use letters, digits, _ and -");
  }
}

}  // namespace upbead
