// Is a mesh one that a solution can stand on?
#pragma once

#include "mesh_report.h"
#include "raw_mesh.h"

namespace upbead {

/// Turns clockwise cells, so that vertices run anticlockwise.
void turn_clockwise_cells(RawMesh& mesh);

/// Says everything that is wrong with a mesh whose cells have been turned.
void check_mesh(const RawMesh& mesh, MeshReport& report);

}  // namespace upbead
