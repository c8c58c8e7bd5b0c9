// A .geo or .msh, through gmsh, as plain numbers.
#pragma once

#include "mesh/mesh_report.h"
#include "mesh/raw_mesh.h"

namespace upbead {

/// Meshes or reads the file, in a confined process: what a script tries outside of it is a mistake too, and is not
/// done. Files *.opt beside meshes and scripts, and settings of the user, are ignored. What is wrong with the file, its
/// parameters, groups and kinds of cells goes into `report`; what it returns then may lack cells.
RawMesh read_raw_mesh(const MeshRequest& request, MeshReport& report);

}  // namespace upbead
