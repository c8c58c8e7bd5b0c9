// Where results for soil that yields are only as good as the mesh, or as the assumption of small strains.
#pragma once

#include "upbead/output/summary.h"

namespace upbead {

/// Warnings slip_line: the largest strain of a cell is several times that of the cells beside it, as where soil
/// slides along a line as narrow as the cells; large_strain: strains are no longer small.
NumberedWarnings yielding_warnings(const Summary& summary);

}  // namespace upbead
