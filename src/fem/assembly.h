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

/// What of a scene is assembled.
struct AssemblyShare {
  std::vector<bool> cells;  ///< by active cell index, these cells and their faces; empty: all
  bool bodies = true;       ///< and the rigid bodies
  /// Only what constants of these cells' materials multiply: the cells, and sides through which they drain or send
  /// waves; and of the forces at the caisson only these cells' own. Else the forces are of all cells and faces.
  bool materials_alone = false;
};

/// Fills M, C, K and the radiation of `system`; `forces`, where given, collects the forces of ground and water at the
/// caisson's nodes. `interface`: the nodes that `unknowns` was made with.
void assemble(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
              CaissonForces* forces, System& system, const AssemblyShare& share = {},
              const std::vector<InterfaceNode>& interface = {});

/// By active cell index, whether a cell is this process's own. Divided by METIS: equal numbers of unknowns,
/// few faces between processes (Karypis & Kumar, SIAM J. Sci. Comput. 20 (1999) 359). Cells that are rigid or absent
/// count 0.
std::vector<bool> own_cells(const Space& space, const Processes& processes);

}  // namespace upbead
