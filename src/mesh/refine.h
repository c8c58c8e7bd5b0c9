// Refinement of chosen cells.
#pragma once

#include <memory>
#include <vector>

#include "upbead/mesh/mesh.h"

namespace upbead {

/// A copy in which the cells (by active cell index) with `chosen` true are split into four. More cells are split so
/// that neighbours differ by at most one level, and that surfaces meet without hanging nodes: the equations change
/// there, and their terms are integrated over the whole side of both cells.
std::unique_ptr<Mesh> refined(const Mesh& mesh, const std::vector<bool>& chosen);

/// A copy whose cells are each split into four.
std::unique_ptr<Mesh> halved(const Mesh& mesh);

}  // namespace upbead
