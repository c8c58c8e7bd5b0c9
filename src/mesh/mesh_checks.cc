// Checks whether a mesh is suitable for a solution.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "mesh_report.h"
#include "raw_mesh.h"

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

/// Reports cells that are degenerate, or on no surface.
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
                   counted(found.count, "cell") + " without area or with an angle of 180 degrees or more" +
                   found.first(),
               "draw the block there nearer to a rectangle, or divide its opposite sides alike");
  if (unnamed.count > 0)
    report.add(counted(unnamed.count, "cell") + " on no physical surface" + unnamed.first(),
               "name what it is made of: Physical Surface(\"name\") = {...};");
}

/// The sides that belong to one cell only.
std::vector<Side> outer_sides(const std::vector<Side>& sorted) {
  std::vector<Side> outer;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool like_last = i > 0 && same_edge(sorted[i - 1], sorted[i]);
    const bool like_next = i + 1 < sorted.size() && same_edge(sorted[i], sorted[i + 1]);
    if (!like_last && !like_next) outer.push_back(sorted[i]);
  }
  return outer;
}

/// Reports cells that overlap.
void check_overlap(const RawMesh& mesh, const std::vector<Side>& sides, MeshReport& report) {
  Found overlap;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (same_edge(sides[i], sides[i - 1]) && sides[i].forward == sides[i - 1].forward)
      overlap.add(mesh.middle(sides[i].first, sides[i].second));
  if (overlap.count > 0) report.add("cells lie over each other" + overlap.first(), "draw every part of the plane once");
}

using Ends = std::pair<unsigned int, unsigned int>;

Ends ends_of(const RawMesh::Edge& edge) {
  return std::minmax(edge.vertices[0], edge.vertices[1]);
}

/// Reports curves without edges, and edges on two curves.
void check_curves(const RawMesh& mesh, const std::vector<Side>& sides, MeshReport& report) {
  std::set<Ends> of_cells;
  for (const Side& side : sides) of_cells.insert({side.first, side.second});
  std::map<Ends, std::set<int>> curves_at;
  std::vector<bool> has_edges(mesh.curves.size(), false);
  for (const RawMesh::Edge& edge : mesh.edges) {
    if (of_cells.count(ends_of(edge)) == 0) continue;
    curves_at[ends_of(edge)].insert(edge.curve);
    has_edges[edge.curve] = true;
  }
  for (std::size_t c = 0; c < has_edges.size(); ++c)
    if (!has_edges[c])
      report.add("curve " + quoted(mesh.curves[c]) + " lies on no side of a cell",
                 "draw it as a side of a surface, or drop it");
  std::map<std::pair<int, int>, Found> on_two;
  for (const auto& [ends, curves] : curves_at)
    if (curves.size() > 1)
      on_two[{*curves.begin(), *std::next(curves.begin())}].add(mesh.middle(ends.first, ends.second));
  for (const auto& [pair, found] : on_two)
    report.add(counted(found.count, "edge") + " on two physical curves, " + quoted(mesh.curves[pair.first]) + " and " +
                   quoted(mesh.curves[pair.second]) + found.first(),
               "keep every curve in one group only");
}

/// Reports outer edges on no curve.
void check_outer(const RawMesh& mesh, const std::vector<Side>& outer, MeshReport& report) {
  std::set<Ends> named;
  for (const RawMesh::Edge& edge : mesh.edges) named.insert(ends_of(edge));
  Found unnamed;
  for (const Side& side : outer)
    if (named.count({side.first, side.second}) == 0) unnamed.add(mesh.middle(side.first, side.second));
  if (unnamed.count > 0)
    report.add(counted(unnamed.count, "outer edge") + " on no physical curve" + unnamed.first(),
               "name every outer curve: Physical Curve(\"name\") = {...};");
}

/// Vertices of outer sides from left to right: no other vertices can be unjoined.
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

/// Nodes that touch the side of a cell without belonging to it.
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

/// Reports cells that touch without sharing their nodes. True where there are none.
bool check_joints(const RawMesh& mesh, const std::vector<Side>& outer, MeshReport& report) {
  const std::vector<unsigned int> vertices = outer_vertices(mesh, outer);
  Unjoined found;
  for (const Side& side : outer) find_unjoined(mesh, side, vertices, found);
  if (found.twice.count > 0)
    report.add("cells are not joined: two nodes at the same place" + found.twice.first(),
               "use the same points and curves for both blocks, or `Coherence;`, or Geometry.AutoCoherence = 1");
  if (found.hanging.count > 0)
    report.add("cells are not joined: a node in the middle of another cell's side" + found.hanging.first(),
               "use the same curves for both blocks (`Coherence;`), so that they are divided alike");
  return found.twice.count + found.hanging.count == 0;
}

/// The surfaces of each part of the mesh whose cells share no node with those of another part.
std::vector<std::set<std::string>> parts_of(const RawMesh& mesh) {
  std::vector<unsigned int> joined(mesh.vertices.size());
  std::iota(joined.begin(), joined.end(), 0U);
  const auto first_of = [&](unsigned int v) {
    while (joined[v] != v) v = joined[v] = joined[joined[v]];
    return v;
  };
  for (const RawMesh::Cell& cell : mesh.cells)
    for (const unsigned int v : cell.vertices) joined[first_of(v)] = first_of(cell.vertices[0]);
  std::map<unsigned int, std::set<std::string>> parts;
  for (const RawMesh::Cell& cell : mesh.cells)
    parts[first_of(cell.vertices[0])].insert(mesh.surfaces[static_cast<std::size_t>(cell.surface)]);
  std::vector<std::set<std::string>> list;
  for (const auto& [vertex, surfaces] : parts) list.push_back(surfaces);
  return list;
}

/// Reports parts that lie apart, by however little: each would move on its own.
void check_parts(const RawMesh& mesh, MeshReport& report) {
  const std::vector<std::set<std::string>> parts = parts_of(mesh);
  if (parts.size() < 2) return;
  std::string names;
  for (const std::set<std::string>& part : parts) {
    names += names.empty() ? "" : "; ";
    for (const std::string& surface : part) names += (surface == *part.begin() ? "" : ", ") + quoted(surface);
  }
  report.add("it falls into " + counted(parts.size(), "part") +
                 " that share no node, so that nothing passes from one to "
                 "the other: " +
                 names,
             "let parts that touch share their points and curves (`Coherence;`), and look for a gap between them");
}

}  // namespace

void check_mesh(const RawMesh& mesh, MeshReport& report) {
  if (mesh.cells.empty()) {
    // If all cells are of a wrong kind, this has been reported already.
    if (report.empty()) report.add("it has no cells", "mesh its surfaces in quadrilaterals (gmsh -2)");
    return;
  }
  check_cells(mesh, report);
  const std::vector<Side> sides = sorted_sides(mesh);
  const std::vector<Side> outer = outer_sides(sides);
  check_overlap(mesh, sides, report);
  check_curves(mesh, sides, report);
  // Sides at an open joint would be taken for outer sides; so would sides where cells of a wrong kind were left out.
  const bool whole = report.empty();
  if (!check_joints(mesh, outer, report) || !whole) return;
  check_parts(mesh, report);
  check_outer(mesh, outer, report);
}

}  // namespace upbead
