// Damping of ground that is shaken as a whole: relative to the moving frame.
#pragma once

#include <map>
#include <string>

#include "fem/unknowns.h"

namespace upbead {

/// Whether a load is the motion of the frame that everything else moves in: uniform, and either of the only fixed
/// side, or of the outcrop below an absorbing side where nothing is fixed.
bool moves_frame(const Scene& scene, const Load& load);

/// Nodal forces of a unit velocity of the frame in the load's direction, by region: Rayleigh's alpha M v damps motion
/// relative to rest, alpha M (v - v_frame) damps it relative to the frame (Chopra, Dynamics of structures (2012),
/// section 9.4).
std::map<std::string, NodalForces> damping_by_frame(const Space& space, const Load& load);

}  // namespace upbead
