// Assembly of M, C and K from cells that deform and bodies that do not.
#pragma once

#include <vector>

#include "upbead/fem/caisson.h"
#include "upbead/fem/rigid_body.h"
#include "upbead/fem/unknowns.h"
#include "upbead/system/system.h"

namespace upbead {

/// Fills M, C and K of `system`; `reaction`, where given, collects what the ground's cells say about the caisson's
/// nodes.
void assemble(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
              GroundReaction* reaction, System& system);

}  // namespace upbead
