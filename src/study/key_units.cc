#include "key_units.h"

#include "case/case_schema.h"
#include "mesh/geo_parameters.h"
#include "upbead/mesh/mesh.h"

namespace upbead {

std::map<std::string, std::string> units_of_keys(const Case& problem) {
  std::map<std::string, std::string> units;
  CaseTables tables;
  Diagnostics report;  // read_case has found no mistake
  case_schema().read(problem.document.root(), "", tables, report);
  case_schema().visit_numbers(
      tables, "", [&units](const KeyInfo& key, const std::string& path, double&) { units.emplace(path, key.unit); });
  for (const GeoParameter& parameter : geo_parameters(mesh_request(problem).file)) {
    const std::size_t colon = parameter.description.find(':');
    const std::string unit = colon == std::string::npos ? "" : parameter.description.substr(0, colon);
    units[dotted("mesh.parameters", parameter.name)] = unit == "-" ? "" : unit;
  }
  return units;
}

}  // namespace upbead
