#include "mesh/versions.h"

#include <gmsh.h>

namespace upbead {

Versions mesh_versions() {
  // gmsh reports its version only within a session, which costs as much time as reading a mesh
  return {{"deal.II", UPBEAD_DEALII_VERSION}, {"gmsh", "interface " GMSH_API_VERSION}};
}

}  // namespace upbead
