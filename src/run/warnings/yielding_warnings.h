// Where the numbers of soil that yields are only as good as the mesh, or as small strains.
#pragma once

#include "upbead/output/summary.h"

namespace upbead {

/// slip_line: the largest strain of a cell is several times that of the cells beside it, as where soil slides along a
/// line that is as narrow as the cells. large_strain: strains are not small any more.
NumberedWarnings yielding_warnings(const Summary& summary);

}  // namespace upbead
