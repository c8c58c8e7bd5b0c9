// Ground that is shaken as a whole is damped relative to what shakes it.
#pragma once

#include <map>
#include <string>

#include "fem/unknowns.h"

namespace upbead {

/// Whether a load is the motion of the frame that all else moves in: uniform, of the only side that is fixed, or of the
/// outcrop below an absorbing one where nothing is fixed.
bool moves_frame(const Scene& scene, const Load& load);

/// Nodal forces of a unit velocity of the frame in the load's direction, by region: Rayleigh's alpha M v holds ground
/// back against rest, alpha M (v - v_frame) against the frame (Chopra, Dynamics of structures (2012), section 9.4).
std::map<std::string, NodalForces> damping_by_frame(const Space& space, const Load& load);

}  // namespace upbead
