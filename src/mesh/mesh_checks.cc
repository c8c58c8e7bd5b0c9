#include "mesh_checks.h"

#include <utility>

namespace upbead {

void turn_clockwise_cells(RawMesh& mesh) {
  for (RawMesh::Cell& cell : mesh.cells) {
    const auto& v = mesh.vertices;
    const auto& i = cell.vertices;
    if (cross(v[i[2]] - v[i[0]], v[i[3]] - v[i[1]]) < 0) std::swap(cell.vertices[1], cell.vertices[3]);
  }
}

void check_mesh(const RawMesh& mesh, MeshReport& report) {
  if (mesh.cells.empty()) {
    // Where all cells are of a wrong kind, that has been said already.
    if (report.empty()) report.add("it has no cells", "mesh its surfaces in quadrilaterals (gmsh -2)");
    return;
  }
  check_cells(mesh, report);
  const std::vector<Side> sides = sorted_sides(mesh);
  const std::vector<Side> outer = outer_sides(sides);
  check_overlap(mesh, sides, report);
  check_curves(mesh, sides, report);
  // The sides of an open joint would be taken for outer ones; so would those where cells of a wrong kind were left out.
  const bool whole = report.empty();
  if (check_joints(mesh, outer, report) && whole) check_outer(mesh, outer, report);
}

}  // namespace upbead
