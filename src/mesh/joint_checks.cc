#include <algorithm>
#include <cmath>

#include "mesh_checks.h"

namespace upbead {

namespace {

/// Vertices of outer sides from left to right. Only they can be unjoined.
std::vector<unsigned int> outer_vertices(const RawMesh& mesh, const std::vector<Side>& outer) {
  std::vector<unsigned int> vertices;
  for (const Side& side : outer) {
    vertices.push_back(side.first);
    vertices.push_back(side.second);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::stable_sort(vertices.begin(), vertices.end(),
                   [&](unsigned int a, unsigned int b) { return mesh.vertices[a][0] < mesh.vertices[b][0]; });
  return vertices;
}

/// What touches the sides of cells without belonging to them.
struct Unjoined {
  Found twice;    ///< nodes at the end of a side
  Found hanging;  ///< nodes in the middle of a side
};

void find_unjoined(const RawMesh& mesh, const Side& side, const std::vector<unsigned int>& vertices, Unjoined& found) {
  constexpr double relative_tolerance = 1e-6;
  const auto &from = mesh.vertices[side.first], &to = mesh.vertices[side.second];
  const auto along = to - from;
  const double tolerance = relative_tolerance * along.norm();
  const double left = std::min(from[0], to[0]) - tolerance, right = std::max(from[0], to[0]) + tolerance;
  auto v = std::lower_bound(vertices.begin(), vertices.end(), left,
                            [&](unsigned int vertex, double x) { return mesh.vertices[vertex][0] < x; });
  for (; v != vertices.end() && mesh.vertices[*v][0] <= right; ++v) {
    if (*v == side.first || *v == side.second) continue;
    const auto& point = mesh.vertices[*v];
    const bool between = (point - from) * along > 0 && (to - point) * along > 0;
    if (point.distance(from) <= tolerance || point.distance(to) <= tolerance)
      found.twice.add(point);
    else if (between && std::abs(cross(along, point - from)) <= tolerance * along.norm())
      found.hanging.add(point);
  }
}

}  // namespace

bool check_joints(const RawMesh& mesh, const std::vector<Side>& outer, MeshReport& report) {
  const std::vector<unsigned int> vertices = outer_vertices(mesh, outer);
  Unjoined found;
  for (const Side& side : outer) find_unjoined(mesh, side, vertices, found);
  if (found.twice.count > 0)
    report.add("cells are not joined: two nodes at the same place, the first at " + to_string(found.twice.where),
               "use the same points and curves for both blocks, or `Coherence;`, or Geometry.AutoCoherence = 1");
  if (found.hanging.count > 0)
    report.add("cells are not joined: a node in the middle of another cell's side, the first at " +
                   to_string(found.hanging.where),
               "use the same curves for both blocks (`Coherence;`), so that they are divided alike");
  return found.twice.count + found.hanging.count == 0;
}

}  // namespace upbead
