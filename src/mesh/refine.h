// Refinement of single cells.
#pragma once

#include <memory>
#include <vector>

#include "upbead/mesh/mesh.h"

namespace upbead {

/// A copy with the cells (by active cell index) for which `chosen` is true into four, and as many more as it takes for
/// neighbours to differ by at most one level and for surfaces to meet without hanging nodes: there the equations
/// change, and their terms are integrated over whole sides of both.
std::unique_ptr<Mesh> refined(const Mesh& mesh, const std::vector<bool>& chosen);

/// A copy whose cells are each split into four.
std::unique_ptr<Mesh> halved(const Mesh& mesh);

}  // namespace upbead
