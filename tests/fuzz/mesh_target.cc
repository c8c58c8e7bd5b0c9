// An accepted mesh has cells of positive area and named outer edges. gmsh itself is not instrumented.
#include <array>

#include "bytes.h"
#include "target.h"
#include "upbead/mesh/mesh.h"

namespace upbead::fuzz {

namespace {

void check(const Mesh& mesh) {
  require(mesh.triangulation.n_active_cells() > 0, "a mesh has cells");
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    require(cell->measure() > 0., "cells have areas");
    require(!mesh.surface_of(cell).empty(), "cells lie on named surfaces");
    for (const auto& face : cell->face_iterators())
      require(!face->at_boundary() || !mesh.curve_of(face).empty(), "outer edges lie on named curves");
  }
}

void read(const std::string& text, const std::map<std::string, double>& parameters = {}) {
  MeshRequest request;
  request.file = memory_file("mesh.msh", text);
  request.place = {"case.toml", 7, 8};
  request.parameters = parameters;
  for (const auto& [name, value] : parameters) request.parameter_places[name] = {"case.toml", 8, 1};
  read_or_refuse([&] { check(*read_mesh(request)); });
}

std::string section(const std::string& name, const std::string& lines, int n) {
  return "$" + name + "\n" + std::to_string(n) + "\n" + lines + "$End" + name + "\n";
}

/// gmsh ends a name at a quotation mark or a line.
std::string name_of(Bytes& bytes) {
  std::string name = bytes.text(bytes.below(12));
  for (char& c : name)
    if (c == '"' || c == '\n' || c == '\r' || c == '\0') c = '_';
  return name;
}

std::string names_of(Bytes& bytes, int& n) {
  std::string lines;
  n = bytes.below(6);
  for (int i = 0; i < n; ++i)
    lines +=
        std::to_string(1 + bytes.below(2)) + " " + std::to_string(1 + bytes.below(4)) + " \"" + name_of(bytes) + "\"\n";
  return lines;
}

std::string nodes_of(Bytes& bytes, int n) {
  std::string lines;
  for (int i = 0; i < n; ++i) {
    lines += std::to_string(i + 1);
    for (int axis = 0; axis < 3; ++axis) lines += " " + (axis == 2 && !bytes.one_in(64) ? "0" : bytes.number_text());
    lines += "\n";
  }
  return lines;
}

/// Lines, triangles and quadrilaterals of any nodes, entities and groups; of second order with one more node a side.
std::string elements_of(Bytes& bytes, int n_nodes, int n, bool second_order) {
  constexpr std::array<int, 4> of_second_order{0, 8, 9, 16};
  std::string lines;
  for (int i = 0; i < n; ++i) {
    const int kind = bytes.below(8), type = kind < 4 ? 1 : kind == 4 ? 2 : 3;
    const int nodes = second_order && type > 1 ? 2 * (type + 1) : second_order ? 3 : type + 1;
    lines += std::to_string(i + 1) + " " +
             std::to_string(second_order ? of_second_order[static_cast<std::size_t>(type)] : type) + " 2 " +
             std::to_string(bytes.below(5)) + " " + std::to_string(1 + bytes.below(4));
    for (int c = 0; c < nodes; ++c) lines += " " + std::to_string(1 + bytes.below(n_nodes));
    lines += "\n";
  }
  return lines;
}

}  // namespace

void try_mesh(std::string_view bytes) {
  read(std::string(bytes));
}

void try_groups(std::string_view input) {
  Bytes bytes(input);
  int n_names = 0;
  const std::string names = names_of(bytes, n_names);
  const int n_nodes = 4 + bytes.below(6), n_elements = bytes.below(16);
  const std::string nodes = nodes_of(bytes, n_nodes),
                    elements = elements_of(bytes, n_nodes, n_elements, input.size() % 8 == 7);
  std::map<std::string, double> parameters;
  if (bytes.one_in(8)) parameters[bytes.text(bytes.below(10))] = bytes.number();
  read("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + section("PhysicalNames", names, n_names) +
           section("Nodes", nodes, n_nodes) + section("Elements", elements, n_elements),
       parameters);
}

}  // namespace upbead::fuzz
