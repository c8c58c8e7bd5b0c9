// The ground under a strip, in cells that grow with the distance from its edges.
#pragma once

#include <memory>

#include "footing.h"
#include "upbead/mesh/mesh.h"

namespace upbead::test {

constexpr double half_width = 0.5;  ///< of the footing (m)

/// Curves: "foot", "bed" beside it, "base", "far" and, if only half the footing is modelled, "middle".
std::unique_ptr<Mesh> ground_mesh(const Footing& footing);

}  // namespace upbead::test
