// Does the scene fit the mesh? Everything that can be said before solving, by the names of groups.
#pragma once

#include <vector>

#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// All that is wrong, at keys of the case ("regions.rubble", "boundaries", "probes.A.at"): surfaces without a region,
/// regions without a surface, outer curves without a condition, conditions for no outer curve, a missing or superfluous
/// pressure condition, supports on a rigid region, rigid regions that touch, a caisson that something else than its
/// bottom holds or that is damped, loads on curves that are not there or have no length in their table of intensities,
/// pressures on a bed under modelled water, waves where there are none, free water without inertia, probes outside the
/// mesh. A water region without a surface, and with it boundaries of no curve, is a sea that the mesh leaves out: fine.
Diagnostics check_scene(const Scene& scene, const Mesh& mesh);

}  // namespace upbead
