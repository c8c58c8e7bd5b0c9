// gmsh in this process, which should be a confined one; and checks of its files that need no gmsh.
#pragma once

#include "mesh_report.h"

namespace upbead {

bool is_script(const std::string& file);

/// Reports what is wrong before gmsh reads anything: file missing or not gmsh's, unknown parameters.
void check_source(const MeshRequest& request, MeshReport& report);

/// Leaves a meshed model in gmsh, or reports the errors that gmsh found. gmsh starts anew, without the settings of
/// the user, and prints nothing. It has one state per process and is not closed: it ends with the confined process.
void open_mesh(const MeshRequest& request, MeshReport& report);

}  // namespace upbead
