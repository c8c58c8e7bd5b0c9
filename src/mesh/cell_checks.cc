#include <algorithm>
#include <map>

#include "mesh_checks.h"

namespace upbead {

namespace {

/// Smallest sine of the cell's angles; negative for an angle of more than 180 degrees.
double smallest_sine(const RawMesh& mesh, const RawMesh::Cell& cell) {
  double smallest = 1;
  for (unsigned int i = 0; i < 4; ++i) {
    const auto& corner = mesh.vertices[cell.vertices[i]];
    const auto ahead = mesh.vertices[cell.vertices[(i + 1) % 4]] - corner;
    const auto behind = mesh.vertices[cell.vertices[(i + 3) % 4]] - corner;
    const double lengths = ahead.norm() * behind.norm();
    smallest = std::min(smallest, lengths > 0 ? cross(ahead, behind) / lengths : 0.0);
  }
  return smallest;
}

}  // namespace

void check_cells(const RawMesh& mesh, MeshReport& report) {
  constexpr double flat = 1e-6;
  std::map<int, Found> degenerate;
  Found unnamed;
  for (const RawMesh::Cell& cell : mesh.cells) {
    if (smallest_sine(mesh, cell) < flat) degenerate[cell.surface].add(mesh.middle(cell));
    if (cell.surface < 0) unnamed.add(mesh.middle(cell));
  }
  for (const auto& [surface, found] : degenerate)
    report.add((surface < 0 ? "there are " : "surface " + quoted(mesh.surfaces[surface]) + " has ") +
                   counted(found.count, "cell") +
                   " without area or with an angle of 180 degrees or more, the first at " + to_string(found.where),
               "draw the block there nearer to a rectangle, or divide its opposite sides alike");
  if (unnamed.count > 0)
    report.add(counted(unnamed.count, "cell") + " on no physical surface, the first at " + to_string(unnamed.where),
               "name what it is made of: Physical Surface(\"name\") = {...};");
}

void check_overlap(const RawMesh& mesh, const std::vector<Side>& sides, MeshReport& report) {
  Found overlap;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (same_edge(sides[i], sides[i - 1]) && sides[i].forward == sides[i - 1].forward)
      overlap.add(mesh.middle(sides[i].first, sides[i].second));
  if (overlap.count > 0)
    report.add("cells lie over each other, the first at " + to_string(overlap.where),
               "draw every part of the plane once");
}

}  // namespace upbead
