// Where the mesh of a case comes from.
#include <filesystem>

#include "upbead/case/case.h"
#include "upbead/mesh/mesh.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// What a mesh starts from that is refined where it must be.
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

}  // namespace upbead
