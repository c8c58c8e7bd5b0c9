#include <algorithm>
#include <map>
#include <set>

#include "mesh_checks.h"

namespace upbead {

namespace {

using Ends = std::pair<unsigned int, unsigned int>;

Ends ends_of(const RawMesh::Edge& edge) {
  return std::minmax(edge.vertices[0], edge.vertices[1]);
}

}  // namespace

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
                   quoted(mesh.curves[pair.second]) + ", the first at " + to_string(found.where),
               "keep every curve in one group only");
}

void check_outer(const RawMesh& mesh, const std::vector<Side>& outer, MeshReport& report) {
  std::set<Ends> named;
  for (const RawMesh::Edge& edge : mesh.edges) named.insert(ends_of(edge));
  Found unnamed;
  for (const Side& side : outer)
    if (named.count({side.first, side.second}) == 0) unnamed.add(mesh.middle(side.first, side.second));
  if (unnamed.count > 0)
    report.add(counted(unnamed.count, "outer edge") + " on no physical curve, the first at " + to_string(unnamed.where),
               "name every outer curve: Physical Curve(\"name\") = {...};");
}

}  // namespace upbead
