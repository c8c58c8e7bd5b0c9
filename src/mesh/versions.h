// What meshes are made with.
#pragma once

#include "base/version.h"

namespace upbead {

/// Of deal.II, and of gmsh's programming interface.
Versions mesh_versions();

}  // namespace upbead
