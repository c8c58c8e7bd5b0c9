// What of a mesh the response cannot feel before the end of the run.
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

/// A cell is outside where the way from the nearest load or rigid body (by the boxes around them) to it, and on to
/// the nearest reading (a rigid body, the caisson, a probe), is longer than the fastest wave of the whole scene runs
/// until the end. Nothing is where there are fields to write, or waves of infinite speed (incompressible water, no
/// inertia). `scene` is resolved.
DomainOfInfluence domain_of_influence(const Scene& scene, const Mesh& mesh);

}  // namespace upbead
