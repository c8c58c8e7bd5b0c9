// Checks that a scene suits its mesh, by the names of groups, before anything is solved.
#pragma once

#include <vector>

#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// All mistakes, at keys of the case ("regions.rubble", "boundaries", "probes.A.at"): surfaces without a region,
/// regions without a surface, outer curves without a condition, conditions for no outer curve, a missing or
/// superfluous pressure condition, supports on a rigid region, rigid regions that touch, a caisson that is damped or
/// held elsewhere than at its bottom, loads on curves that do not exist or have no length in their table of
/// intensities, pressures on a bed under modelled water, waves where there is no free water, free water without
/// inertia, probes outside the mesh. No mistake: a water region without a surface, and its boundaries without a
/// curve, as the mesh may leave out the sea.
Diagnostics check_scene(const Scene& scene, const Mesh& mesh);

}  // namespace upbead
