// Opens the file of a mesh in gmsh, after what can be checked without gmsh.
#pragma once

#include "gmsh_session.h"
#include "mesh_report.h"

namespace upbead {

/// Leaves a meshed model in gmsh, or says in `report` why not: file missing or not gmsh's, unknown parameters, and what
/// gmsh itself found wrong.
void open_mesh(const MeshRequest& request, GmshSession& session, MeshReport& report);

}  // namespace upbead
