// The part of a mesh that some cells fill.
#pragma once

#include <algorithm>

#include "base/numbers.h"
#include "upbead/mesh/mesh.h"

namespace upbead {

struct Extent {
  double left = infinity, right = -infinity, low = infinity, high = -infinity;  ///< m
  double area = 0.;                                                             ///< m2

  void add(const dealii::Triangulation<dim>::active_cell_iterator& cell) {
    for (const unsigned v : cell->vertex_indices()) {
      left = std::min(left, cell->vertex(v)[0]);
      right = std::max(right, cell->vertex(v)[0]);
      low = std::min(low, cell->vertex(v)[1]);
      high = std::max(high, cell->vertex(v)[1]);
    }
    area += area_of(cell);
  }
  double width() const { return right - left; }
  double height() const { return high - low; }
};

}  // namespace upbead
