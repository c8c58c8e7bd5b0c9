// Is a mesh one that a solution can stand on?
#pragma once

#include "mesh_report.h"
#include "mesh_sides.h"
#include "raw_mesh.h"

namespace upbead {

/// Turns clockwise cells, so that vertices run anticlockwise.
void turn_clockwise_cells(RawMesh& mesh);

/// Says everything that is wrong with a mesh whose cells have been turned.
void check_mesh(const RawMesh& mesh, MeshReport& report);

/// The parts of check_mesh, by what they look at.
/// Cells: degenerate, or on no surface.
void check_cells(const RawMesh& mesh, MeshReport& report);
/// Cells that lie over each other.
void check_overlap(const RawMesh& mesh, const std::vector<Side>& sides, MeshReport& report);
/// Cells that touch without sharing their nodes. True where there are none.
bool check_joints(const RawMesh& mesh, const std::vector<Side>& outer, MeshReport& report);
/// Curves without edges, edges on two curves.
void check_curves(const RawMesh& mesh, const std::vector<Side>& sides, MeshReport& report);
/// Outer edges on no curve.
void check_outer(const RawMesh& mesh, const std::vector<Side>& outer, MeshReport& report);

}  // namespace upbead
