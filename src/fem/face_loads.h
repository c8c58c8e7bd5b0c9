// Loads on boundary curves and on rigid bodies, as vectors over degrees of freedom.
#pragma once

#include <deal.II/base/tensor.h>

#include <map>
#include <string>
#include <vector>

#include "fem/space.h"

namespace upbead {

/// Nodal forces of a load at f(t) = 1 on the cells of one region: degree of freedom -> force (N/m).
using NodalForces = std::map<unsigned, double>;

/// Nodal forces of a load on a curve, by the region that the faces belong to. The relative intensity is integrated
/// exactly: faces are split at the heights of its table. Of a load of kind force the resultant is value times
/// direction.
std::map<std::string, NodalForces> curve_forces(const Space& space, const Load& load);

}  // namespace upbead
