// Versions of the programs that make meshes.
#pragma once

#include "base/version.h"

namespace upbead {

/// Versions of deal.II, and of gmsh's programming interface.
Versions mesh_versions();

}  // namespace upbead
