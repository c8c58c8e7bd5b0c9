#include "raw_mesh.h"

#include <algorithm>
#include <tuple>

namespace upbead {

bool same_edge(const Side& a, const Side& b) {
  return a.first == b.first && a.second == b.second;
}

std::vector<Side> sorted_sides(const RawMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(4 * mesh.cells.size());
  for (const RawMesh::Cell& cell : mesh.cells)
    for (unsigned int i = 0; i < 4; ++i) {
      const unsigned int from = cell.vertices[i], to = cell.vertices[(i + 1) % 4];
      sides.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.first, a.second, a.forward) < std::tie(b.first, b.second, b.forward);
  });
  return sides;
}

void turn_clockwise_cells(RawMesh& mesh) {
  for (RawMesh::Cell& cell : mesh.cells) {
    const auto& v = mesh.vertices;
    const auto& i = cell.vertices;
    if (cross(v[i[2]] - v[i[0]], v[i[3]] - v[i[1]]) < 0) std::swap(cell.vertices[1], cell.vertices[3]);
  }
}

}  // namespace upbead
