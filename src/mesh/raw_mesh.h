// A mesh as plain numbers, between gmsh and deal.II.
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace upbead {

struct RawMesh {
  struct Cell {
    std::array<unsigned int, 4> vertices;  ///< around the cell, either way
    int surface;                           ///< index into surfaces, -1 where none
  };
  struct Edge {
    std::array<unsigned int, 2> vertices;
    int curve;  ///< index into curves
  };

  std::vector<dealii::Point<2>> vertices;
  std::vector<Cell> cells;
  std::vector<Edge> edges;  ///< those on named curves only; an edge on two curves is there twice
  std::vector<std::string> surfaces;
  std::vector<std::string> curves;

  dealii::Point<2> middle(unsigned int a, unsigned int b) const {
    return vertices[a] + (vertices[b] - vertices[a]) / 2;
  }
  dealii::Point<2> middle(const Cell& cell) const {
    return middle(cell.vertices[0], cell.vertices[2]) +
           (middle(cell.vertices[1], cell.vertices[3]) - middle(cell.vertices[0], cell.vertices[2])) / 2;
  }
};

/// Twice the signed area between two vectors.
inline double cross(const dealii::Tensor<1, 2>& a, const dealii::Tensor<1, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Side of a cell, its vertices in rising order.
struct Side {
  unsigned int first, second;
  bool forward;  ///< the cell, run anticlockwise, runs from first to second
};

bool same_edge(const Side& a, const Side& b);

/// All sides of all cells, sorted by their vertices: those that cells share stand together.
std::vector<Side> sorted_sides(const RawMesh& mesh);

/// The sides that one cell only has.
std::vector<Side> outer_sides(const std::vector<Side>& sorted);

}  // namespace upbead
