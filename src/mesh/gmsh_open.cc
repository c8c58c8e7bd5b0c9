#include "gmsh_open.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/text.h"
#include "mesh/geo_parameters.h"

namespace upbead {

namespace {

enum class FileKind { script, mesh, unknown };

FileKind kind_of(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  return ending == ".geo" ? FileKind::script : ending == ".msh" ? FileKind::mesh : FileKind::unknown;
}

/// gmsh takes for a script whatever does not begin as a mesh.
bool begins_as_mesh(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  std::getline(in, line);
  return line.rfind("$MeshFormat", 0) == 0 || line.rfind("$Comments", 0) == 0;
}

bool has_mesh_format(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string beginning(4096, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find("$MeshFormat") != std::string::npos && begins_as_mesh(file);
}

bool ends_with_newline(const std::string& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (in.tellg() <= 0) return true;
  in.seekg(-1, std::ios::end);
  return in.get() == '\n';
}

void check_file(const std::string& file, MeshReport& report) {
  if (!std::filesystem::exists(file))
    return report.add("there is no file '" + file + "'", "check the name and the folder");
  if (std::filesystem::is_directory(file)) return report.add("'" + file + "' is a folder", "name the file in it");
  if (!std::filesystem::is_regular_file(file))
    return report.add("'" + file + "' is not a file of a known length", "name a file on a disk");
  if (!std::ifstream(file)) return report.add("'" + file + "' cannot be read", "check its permissions");
  switch (kind_of(file)) {
    case FileKind::unknown:
      return report.add("it is neither a .geo nor a .msh", "give a gmsh script (.geo) or a gmsh mesh (.msh)");
    case FileKind::mesh:
      if (!has_mesh_format(file))
        report.add("it is not a gmsh mesh: it has no $MeshFormat at its beginning",
                   "save it from gmsh: File > Export, format 2.2 or 4.1");
      return;
    case FileKind::script:
      if (!ends_with_newline(file))
        report.add("its last line does not end with a newline, so gmsh may lose it", "end the file with a newline");
  }
}

std::string with_default(const GeoParameter& parameter) {
  return parameter.name + " = " + parameter.default_value;
}

void check_parameters(const MeshRequest& request, MeshReport& report) {
  if (request.parameters.empty()) return;
  if (kind_of(request.file) == FileKind::mesh)
    return report.add_about_parameters(
        "a .msh is finished and takes no parameters, not '" + request.parameters.begin()->first + "'",
        "drop them, or name the .geo that made it");
  std::vector<std::string> names, defaults;
  for (const GeoParameter& parameter : geo_parameters(request.file)) {
    names.push_back(parameter.name);
    defaults.push_back(with_default(parameter));
  }
  for (const auto& [name, value] : request.parameters) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      const std::string near = nearest(name, names);
      report.add_about_parameters("it has no parameter '" + name + "'",
                                  (near.empty() ? "" : "did you mean '" + near + "'? ") +
                                      (names.empty() ? "it has none (no DefineConstant)" : "it has " + join(defaults)));
    } else if (!std::isfinite(value)) {
      report.add_about_parameters("parameter '" + name + "' is not a finite number", "give a finite number");
    }
  }
}

}  // namespace

bool is_script(const std::string& file) {
  return kind_of(file) == FileKind::script;
}

void check_source(const MeshRequest& request, MeshReport& report) {
  check_file(request.file, report);
  if (report.empty()) check_parameters(request, report);
}

void open_mesh(const MeshRequest& request, GmshSession& session, MeshReport& report) {
  const bool script = is_script(request.file);
  try {
    if (script) {
      session.open_script(request.file, request.parameters);
      session.generate();
    } else {
      session.open_mesh(request.file);
    }
  } catch (const GmshError& error) {
    // One slip makes many messages; the first ones tell.
    const std::size_t count = std::min<std::size_t>(error.messages.size(), 5);
    for (std::size_t i = 0; i < count; ++i)
      report.add_about_parameters("gmsh says: " + error.messages[i],
                                  script ? "mend the script or its parameters" : "save the mesh again from gmsh");
  }
}

}  // namespace upbead
