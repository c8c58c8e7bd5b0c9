// Small meshes on disk, and what read_mesh says about them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"

namespace upbead::test {

/// A folder that is removed by the destructor.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "upbead_mesh_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  /// Writes a file and gives its path.
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path(name);
  }
  std::string path(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A gmsh 2.2 mesh, line by line. Nodes: number, x, y, z. Elements: number, type, 2, physical, entity, nodes.
struct MshFile {
  std::vector<std::string> names, nodes, elements;

  std::string text() const {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + section("PhysicalNames", names) + section("Nodes", nodes) +
           section("Elements", elements);
  }

 private:
  static std::string section(const std::string& name, const std::vector<std::string>& lines) {
    std::string text = "$" + name + "\n" + std::to_string(lines.size()) + "\n";
    for (const std::string& line : lines) text += line + "\n";
    return text + "$End" + name + "\n";
  }
};

/// One unit cell of surface 'soil' within the curves 'base' and 'rest'. The cell is the last element.
inline MshFile unit_cell() {
  return {{"1 1 \"base\"", "1 2 \"rest\"", "2 1 \"soil\""},
          {"1 0 0 0", "2 1 0 0", "3 1 1 0", "4 0 1 0"},
          {"1 1 2 1 1 1 2", "2 1 2 2 2 2 3", "3 1 2 2 3 3 4", "4 1 2 2 4 4 1", "5 3 2 1 1 1 2 3 4"}};
}

/// A script for the rectangle of `width` (a parameter) by 1; `more` is added to it.
inline std::string rectangle_script(const std::string& more) {
  return "DefineConstant[ width = 2 ]; // m: width of it\n"
         "Point(1) = {0, 0, 0}; Point(2) = {width, 0, 0}; Point(3) = {width, 1, 0}; Point(4) = {0, 1, 0};\n"
         "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n"
         "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};\n"
         "Physical Surface(\"soil\") = {1}; Physical Curve(\"side\") = {1, 2, 3, 4};\n" +
         more + "\n";
}

inline MeshRequest request_for(const std::string& file) {
  MeshRequest request;
  request.file = file;
  request.place = {"case.toml", 7, 8};
  return request;
}

/// The messages of read_mesh, as "file:line:column: what; cure"; empty if the mesh is accepted.
inline std::vector<std::string> complaints(const MeshRequest& request) try {
  read_mesh(request);
  return {};
} catch (const InputError& error) {
  std::vector<std::string> said;
  for (const Diagnostic& mistake : error.diagnostics()) said.push_back(to_string(mistake));
  return said;
}

inline std::vector<std::string> complaints(const MshFile& file) {
  const TemporaryFolder folder;
  return complaints(request_for(folder.write("a.msh", file.text())));
}

inline std::vector<std::string> complaints_of_script(const std::string& text) {
  const TemporaryFolder folder;
  return complaints(request_for(folder.write("a.geo", text)));
}

/// "case.toml:7:8: mesh 'a.msh': what; cure", as a list of one.
inline std::vector<std::string> said(const std::string& what, const std::string& name = "a.msh") {
  return {"case.toml:7:8: mesh '" + name + "': " + what};
}

/// The request for a geometry of the program.
inline MeshRequest geometry(const std::string& name, const std::map<std::string, double>& parameters = {}) {
  MeshRequest request = request_for(std::string(UPBEAD_MESHES) + "/" + name + ".geo");
  request.parameters = parameters;
  return request;
}

inline std::map<std::string, double> areas(const Mesh& mesh) {
  std::map<std::string, double> areas;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) areas[mesh.surface_of(cell)] += cell->measure();
  return areas;
}

inline std::map<std::string, unsigned int> cell_counts(const Mesh& mesh) {
  std::map<std::string, unsigned int> counts;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) ++counts[mesh.surface_of(cell)];
  return counts;
}

/// Length of each named curve, every face counted once.
inline std::map<std::string, double> lengths(const Mesh& mesh) {
  std::map<std::string, double> lengths;
  for (const auto& face : mesh.triangulation.active_face_iterators())
    if (!mesh.curve_of(face).empty()) lengths[mesh.curve_of(face)] += face->measure();
  return lengths;
}

/// Smallest sine of any angle of any cell; negative for an angle of more than 180 degrees.
inline double smallest_sine(const Mesh& mesh) {
  double smallest = 1;
  const unsigned int around[] = {0, 1, 3, 2};
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (unsigned int i = 0; i < 4; ++i) {
      const auto ahead = cell->vertex(around[(i + 1) % 4]) - cell->vertex(around[i]);
      const auto behind = cell->vertex(around[(i + 3) % 4]) - cell->vertex(around[i]);
      smallest = std::min(smallest, (ahead[0] * behind[1] - ahead[1] * behind[0]) / ahead.norm() / behind.norm());
    }
  return smallest;
}

}  // namespace upbead::test
