// The cells of a mesh that cannot influence the response before the end of the run.
#pragma once

#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

struct DomainOfInfluence {
  std::vector<bool> outside;  ///< by active cell index; empty where every cell is inside
  int n_outside = 0;
  double speed = 0.;  ///< of the fastest wave (m/s)
};

/// A cell is outside if the path from the nearest load or rigid body (from its bounding box) to the cell and on to
/// the nearest reading (a rigid body, the caisson, a probe) is longer than the distance that the fastest wave of the
/// scene travels until the end. No cell is outside where fields are written, or where waves have infinite speed
/// (incompressible water, no inertia). `scene` is resolved.
DomainOfInfluence domain_of_influence(const Scene& scene, const Mesh& mesh);

}  // namespace upbead
