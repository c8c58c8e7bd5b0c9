// The fields on a cell.
#pragma once

#include "upbead/model/region.h"

namespace upbead {

/// The fields on a cell; also its index into the collection of elements of a Space.
enum class CellKind : unsigned { solid = 0, darcy = 1, inertial = 2, water = 3, absent = 4 };

/// That of the cells of a region whose choices are made.
CellKind kind_of(const Region& region);

}  // namespace upbead
