#include "output/versions.h"

#include <hdf5.h>

#include <nlohmann/json.hpp>

#include "algebra/versions.h"
#include "dynamics/real_fft.h"
#include "mesh/versions.h"

namespace upbead {

const Versions& versions() {
  static const Versions all = [] {
    Versions list = base_versions();
    const std::string hdf5 =
        std::to_string(H5_VERS_MAJOR) + "." + std::to_string(H5_VERS_MINOR) + "." + std::to_string(H5_VERS_RELEASE);
    for (const Versions& part : {mesh_versions(), algebra_versions(), dynamics_versions(), Versions{{"HDF5", hdf5}}})
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
