// The sides of cells, brought together where two cells share one.
#pragma once

#include <cstddef>
#include <vector>

#include "raw_mesh.h"

namespace upbead {

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
