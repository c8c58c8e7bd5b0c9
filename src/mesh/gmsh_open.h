// Opens the file of a mesh in gmsh; and what can be checked without gmsh.
#pragma once

#include "gmsh_session.h"
#include "mesh_report.h"

namespace upbead {

bool is_script(const std::string& file);

/// Says in `report` what is wrong before gmsh has seen anything: file missing or not gmsh's, unknown parameters.
void check_source(const MeshRequest& request, MeshReport& report);

/// Leaves a meshed model in gmsh, or says in `report` what gmsh itself found wrong.
void open_mesh(const MeshRequest& request, GmshSession& session, MeshReport& report);

}  // namespace upbead
