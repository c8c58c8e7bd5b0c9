// Still water that stands at two levels, in front of a caisson and behind it.
#pragma once

#include <optional>

#include "upbead/run/simulation.h"

namespace upbead {

/// None without a caisson between two waters of the mesh, where both stand at one level, or where the loads end with
/// that push: then it is one of them.
std::optional<HarbourSummary> harbour_of(const Simulation& simulation);

/// Warning harbour_level: the scene has one level at rest, and the push by the other is in the checks of friction
/// alone. It voids the verdict unless it is small against mu W'.
NumberedWarnings harbour_warnings(const Simulation& simulation);

}  // namespace upbead
