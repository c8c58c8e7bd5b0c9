// Whether the section is held, and moves at its sides as the ground beyond would.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Warnings nothing_holds: no condition and no spring holds the section along x or y, so that loads shift it against
/// its dashpots for good; sides_unlike_ground: the base is shaken as a whole, and upright sides of soil are free, or
/// absorb relative to rest.
NumberedWarnings support_warnings(const Simulation& simulation);

/// Whether a load moves that curve.
bool is_moved(const Scene& scene, const std::string& curve);

/// Warning impact_unresolved: the caisson has struck its ground in steps longer than a share of the time of an impact.
NumberedWarnings impact_warnings(const Solution& solution);

}  // namespace upbead
