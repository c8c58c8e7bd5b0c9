// A mesh as plain numbers, between gmsh and deal.II.
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "upbead/mesh/request.h"

namespace upbead {

struct RawMesh {
  struct Cell {
    std::array<unsigned int, 4> vertices;  ///< in order around the cell, in either direction
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
  int n_divided = 0;      ///< number of triangles from which cells were made
  int n_high_order = 0;   ///< number of cells of second or higher order, of which only the corners are kept
  double most_bent = 0.;  ///< largest distance of one of their nodes from the chord of its side, over the chord

  dealii::Point<2> middle(unsigned int a, unsigned int b) const {
    return vertices[a] + (vertices[b] - vertices[a]) / 2;
  }
  dealii::Point<2> middle(const Cell& cell) const {
    return middle(cell.vertices[0], cell.vertices[2]) +
           (middle(cell.vertices[1], cell.vertices[3]) - middle(cell.vertices[0], cell.vertices[2])) / 2;
  }
};

struct RawTriangle {
  std::array<unsigned int, 3> vertices;
  int surface;  ///< index into surfaces, -1 where none
};

/// Makes three quadrilaterals of each triangle and adds them to the cells of a mesh; these are split into four each,
/// and the edges into two, so that all match.
void divide_triangles(const std::vector<RawTriangle>& triangles, RawMesh& mesh);

/// Twice the signed area between two vectors.
inline double cross(const dealii::Tensor<1, 2>& a, const dealii::Tensor<1, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Side of a cell, its vertices in rising order.
struct Side {
  unsigned int first, second;
  bool forward;  ///< going anticlockwise around the cell, first comes before second
};

bool same_edge(const Side& a, const Side& b);

/// All sides of all cells, sorted by their vertices: equal sides of different cells stand together.
std::vector<Side> sorted_sides(const RawMesh& mesh);

class MeshReport;

/// Meshes or reads the file in a confined process. What a script tries beyond that is refused and reported as a
/// mistake. Files *.opt beside meshes and scripts, and settings of the user, are ignored. `report` receives what is
/// wrong with the file, its parameters, groups and kinds of cells; the mesh returned may then lack cells.
RawMesh read_raw_mesh(const MeshRequest& request, MeshReport& report);

/// Turns clockwise cells, so that vertices run anticlockwise.
void turn_clockwise_cells(RawMesh& mesh);

/// Reports all that is wrong with a mesh whose cells have been turned.
void check_mesh(const RawMesh& mesh, MeshReport& report);

}  // namespace upbead
