// Assembly of M, C and K from cells that deform, faces between regions or at the outside, and rigid bodies.
#pragma once

#include <vector>

#include "fem/caisson/caisson.h"
#include "fem/caisson/rigid_body.h"
#include "fem/space.h"
#include "fem/unknowns.h"
#include "upbead/algebra/processes.h"
#include "upbead/system/system.h"

namespace upbead {

/// Fills M, C, K and the radiation of `system`; `forces`, where given, collects the forces of ground and water at the
/// caisson's nodes. With `own`, by active cell index, the matrices hold only the parts of these cells, their faces,
/// and of the bodies if `with_bodies`; `forces` collects the parts of all cells. `interface`: the nodes that
/// `unknowns` was made with.
void assemble(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
              CaissonForces* forces, System& system, const std::vector<bool>& own = {}, bool with_bodies = true,
              const std::vector<InterfaceNode>& interface = {});

/// By active cell index, whether a cell is this process's own. Divided by METIS: equal numbers of degrees of freedom,
/// few faces between processes (Karypis & Kumar, SIAM J. Sci. Comput. 20 (1999) 359). Cells that are rigid or absent
/// count 0.
std::vector<bool> own_cells(const Space& space, const Processes& processes);

}  // namespace upbead
