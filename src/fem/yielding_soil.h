// Soil of a mesh that yields: a law of stress at every point of quadrature, and the internal force that comes of it.
#pragma once

#include <memory>
#include <vector>

#include "fem/unknowns.h"
#include "material/hysteretic_law.h"
#include "system/internal_force.h"

namespace upbead {

/// The law of each cell; cells without one stay elastic and are skipped. By active cell index.
using CellLaws = std::vector<std::shared_ptr<const HystereticLaw>>;

/// p = integral of B^T (D eps - sigma) over the cells that have a law, sigma its answer to the strain since rest and D
/// the elastic law of the cell, whose stiffness is in K. `space` and `unknowns` outlive it.
std::unique_ptr<InternalForce> yielding_soil(const Space& space, const Unknowns& unknowns, const CellLaws& laws);

}  // namespace upbead
