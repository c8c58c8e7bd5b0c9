// The pore pressure under the caisson.
#pragma once

#include <array>

#include "fem/caisson/caisson.h"

namespace upbead {

/// Work of the excess pore pressure on the caisson's contact with porous ground in unit motions about the bottom's
/// centre, as rows over x': the uplift U (N/m, motion_y) and its moment (N m/m, motion_rotation). It is a part of the
/// total normal force, not an outer load besides it.
std::array<Row, n_motions> uplift_rows(const Space& space, const Unknowns& unknowns, const Caisson& caisson);

}  // namespace upbead
