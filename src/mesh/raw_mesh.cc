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

std::vector<Side> outer_sides(const std::vector<Side>& sorted) {
  std::vector<Side> outer;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool like_last = i > 0 && same_edge(sorted[i - 1], sorted[i]);
    const bool like_next = i + 1 < sorted.size() && same_edge(sorted[i], sorted[i + 1]);
    if (!like_last && !like_next) outer.push_back(sorted[i]);
  }
  return outer;
}

}  // namespace upbead
