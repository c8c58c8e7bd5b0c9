// gmsh in this process, which is to be a confined one; and what can be checked of its files without it.
#pragma once

#include "mesh_report.h"

namespace upbead {

bool is_script(const std::string& file);

/// Says in `report` what is wrong before gmsh has seen anything: file missing or not gmsh's, unknown parameters.
void check_source(const MeshRequest& request, MeshReport& report);

/// Leaves a meshed model in gmsh, or says in `report` what gmsh itself found wrong. gmsh begins anew, without the
/// settings of the user, silent. It has one state per process and is not closed: the confined process ends with it.
void open_mesh(const MeshRequest& request, MeshReport& report);

}  // namespace upbead
