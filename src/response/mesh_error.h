// How wrong the mesh makes F_T, and which cells do.
#pragma once

#include <vector>

#include "fem/compile.h"

namespace upbead {

/// What cells have of the error of F_T, relative to its size: tells one cell from another, not how large the error is.
struct MeshError {
  std::vector<double> of_cell;  ///< by active cell index
  double sum = 0.;              ///< of all cells, as if none offset another
};

/// Of the scene's own loads, at frequencies from one half-wave in the run to four in the shortest load, each
/// counting for what it has of F_T. As the
/// equations are symmetric, the work F x_G of a force F is wrong by the square of the error of x in the energy norm
/// (goal and load are one: Becker and Rannacher 2001, sec. 2), and F_T = P - m x_G'' with it. Low frequencies see the
/// singular corners of the caisson's bottom, high ones the cells that are too long for waves. Needs a caisson and
/// inertia. Throws NumericsError as solve_spectrum does.
MeshError mesh_error(const Scene& scene, const Space& space, const Unknowns& unknowns, const CompiledScene& compiled);

}  // namespace upbead
