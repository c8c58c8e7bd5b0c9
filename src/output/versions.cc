#include "upbead/output/versions.h"

#include <hdf5.h>

#include <nlohmann/json.hpp>

#include "upbead/algebra/versions.h"
#include "upbead/dynamics/versions.h"
#include "upbead/mesh/versions.h"

namespace upbead {

namespace {

Versions hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return {{"HDF5", std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release)}};
}

}  // namespace

const Versions& versions() {
  static const Versions all = [] {
    Versions list = base_versions();
    for (const Versions& part : {mesh_versions(), algebra_versions(), dynamics_versions(), hdf5_version()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

std::string versions_line() {
  std::string line;
  for (const auto& [name, version] : versions()) line += (line.empty() ? "" : "; ") + name + " " + version;
  return line;
}

std::string versions_text() {
  constexpr std::size_t width = 10;
  std::string text = program_version();
  for (const auto& [name, version] : versions())
    if (name != "upbead") text += "\n" + name + std::string(width - name.size(), ' ') + version;
  return text;
}

nlohmann::ordered_json versions_object() {
  nlohmann::ordered_json object;
  for (const auto& [name, version] : versions()) object[name] = version;
  return object;
}

}  // namespace upbead
