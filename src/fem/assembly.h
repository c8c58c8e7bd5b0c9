// Assembly of M, C and K from cells that deform, faces where regions or the outside meet, and bodies that do not
// deform.
#pragma once

#include <vector>

#include "fem/caisson/caisson.h"
#include "fem/caisson/rigid_body.h"
#include "fem/space.h"
#include "fem/unknowns.h"
#include "upbead/algebra/processes.h"
#include "upbead/system/system.h"

namespace upbead {

/// Fills M, C, K and the radiation of `system`; `forces`, where given, collects what ground and water say about the
/// caisson's nodes. With `own`, by active cell index, what is filled in is of these cells, their faces, and the bodies
/// where `with_bodies`; `forces` collects all. `interface`: the nodes that `unknowns` was made with.
void assemble(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
              CaissonForces* forces, System& system, const std::vector<bool>& own = {}, bool with_bodies = true,
              const std::vector<InterfaceNode>& interface = {});

/// By active cell index, whether a cell is this process's own. By METIS: equal numbers of degrees of freedom, few faces
/// between (Karypis & Kumar, SIAM J. Sci. Comput. 20 (1999) 359). Cells that are rigid or absent weigh nothing.
std::vector<bool> own_cells(const Space& space, const Processes& processes);

}  // namespace upbead
