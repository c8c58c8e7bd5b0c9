// The cells of a mesh divided among processes.
#pragma once

#include <vector>

#include "fem/space.h"
#include "upbead/algebra/processes.h"

namespace upbead {

/// By active cell index, whether a cell is this process's own. By METIS: equal numbers of degrees of freedom, few faces
/// between (Karypis & Kumar, SIAM J. Sci. Comput. 20 (1999) 359). Cells that are rigid or absent weigh nothing.
std::vector<bool> own_cells(const Space& space, const Processes& processes);

}  // namespace upbead
