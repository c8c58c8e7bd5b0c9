// Still water that stands at two levels, in front of a caisson and behind it.
#pragma once

#include <optional>

#include "upbead/run/simulation.h"

namespace upbead {

/// None without a caisson between two waters of the mesh, or where both stand at one level.
std::optional<HarbourSummary> harbour_of(const Simulation& simulation);

/// Warning harbour_level: the scene has one level at rest, and the push by the other is in the checks of friction
/// alone. It voids the verdict unless it is small against mu W'.
NumberedWarnings harbour_warnings(const Simulation& simulation);

}  // namespace upbead
