// Where the mesh of a case comes from, and the geometries that come with the program.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "upbead/case/case.h"
#include "upbead/mesh/request.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// The coarse mesh from which adaptive refinement starts.
const std::map<std::string, double> coarse_composite{{"cells", 0.35}, {"grading", 3.}};

}  // namespace

MeshRequest mesh_request(const Case& problem) {
  const MeshChoice& mesh = problem.scene.mesh;
  MeshRequest request;
  if (mesh.geometry) {
    request.file = (fs::path(geometry_folder()) / (*mesh.geometry + ".geo")).string();
    request.place = problem.place("mesh.geometry");
  } else {
    request.file = problem.resolve(mesh.file.value());
    request.place = problem.place("mesh.file");
  }
  request.parameters = mesh.parameters;
  for (const auto& [name, value] : mesh.parameters)
    request.parameter_places[name] = problem.place(dotted("mesh.parameters", name));
  request.refine = mesh.refine.value_or(0);
  if (!mesh.refine && mesh.geometry == "composite")
    for (const auto& [name, value] : coarse_composite) request.parameters.emplace(name, value);
  return request;
}

std::string geometry_folder() {
  if (const char* folder = std::getenv("UPBEAD_MESHES")) {
    if (fs::is_directory(folder)) return folder;
    throw InputError(Place(), "UPBEAD_MESHES = '" + std::string(folder) + "' is no folder", "unset or mend it");
  }
  std::error_code code;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  const fs::path installed = program.parent_path().parent_path() / "share" / "upbead" / "meshes";
  if (fs::is_directory(installed, code)) return installed.string();
  if (fs::is_directory(UPBEAD_MESH_DIR)) return UPBEAD_MESH_DIR;
  throw InputError(Place(), "no folder of shipped geometries", "set UPBEAD_MESHES to the folder of the .geo files");
}

std::vector<std::string> geometries() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(geometry_folder()))
    if (entry.path().extension() == ".geo") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace upbead
