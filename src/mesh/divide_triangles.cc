#include <map>

#include "raw_mesh.h"

namespace upbead {

namespace {

/// Adds nodes in the middle of the sides of a mesh, each once.
class Middles {
 public:
  explicit Middles(RawMesh& mesh) : mesh_(mesh) {}

  unsigned int operator()(unsigned int a, unsigned int b) {
    const auto [found, is_new] = number_.try_emplace(std::minmax(a, b), mesh_.vertices.size());
    if (is_new) mesh_.vertices.push_back(mesh_.middle(a, b));
    return found->second;
  }

 private:
  RawMesh& mesh_;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> number_;
};

/// Makes a quadrilateral at every corner: corner, middle of a side, centre, middle of the other side.
template <std::size_t n>
void divide(const std::array<unsigned int, n>& corners, int surface, Middles& middle, RawMesh& mesh,
            std::vector<RawMesh::Cell>& cells) {
  dealii::Point<2> centre;
  for (const unsigned int v : corners) centre += mesh.vertices[v] / static_cast<double>(n);
  const auto centre_number = static_cast<unsigned int>(mesh.vertices.size());
  mesh.vertices.push_back(centre);
  for (std::size_t i = 0; i < n; ++i) {
    const unsigned int v = corners[i];
    cells.push_back(
        {{v, middle(v, corners[(i + 1) % n]), centre_number, middle(v, corners[(i + n - 1) % n])}, surface});
  }
}

}  // namespace

void divide_triangles(const std::vector<RawTriangle>& triangles, RawMesh& mesh) {
  if (triangles.empty()) return;
  mesh.n_divided = static_cast<int>(triangles.size());
  Middles middle(mesh);
  std::vector<RawMesh::Cell> cells;
  cells.reserve(4 * mesh.cells.size() + 3 * triangles.size());
  for (const RawMesh::Cell& cell : mesh.cells) divide(cell.vertices, cell.surface, middle, mesh, cells);
  for (const RawTriangle& triangle : triangles) divide(triangle.vertices, triangle.surface, middle, mesh, cells);
  mesh.cells = std::move(cells);
  std::vector<RawMesh::Edge> edges;
  for (const RawMesh::Edge& edge : mesh.edges) {
    const unsigned int half = middle(edge.vertices[0], edge.vertices[1]);
    edges.push_back({{edge.vertices[0], half}, edge.curve});
    edges.push_back({{half, edge.vertices[1]}, edge.curve});
  }
  mesh.edges = std::move(edges);
}

}  // namespace upbead
