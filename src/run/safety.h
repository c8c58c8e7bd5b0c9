// Whether the ground stands at rest, by which factor its strength may fall, and what follows for all other results.
#pragma once

#include <optional>

#include "upbead/run/simulation.h"

namespace upbead {

/// Where the scene asks for it, and where `so_far` has no rest of soil that fails.
std::optional<SafetySummary> find_safety(const Simulation& simulation, const Summary& so_far);

/// Why the ground cannot be at rest; "" where it can, or where that is not known.
std::string why_not_at_rest(const Summary& summary);

/// The check of the ground at rest, which comes before all others; none where nothing is known of it.
Checks rest_checks(const Scene& scene, const Summary& summary);

/// Warnings no_rest, where there is no state at rest, which voids the verdict, and rest_open, where it is not known
/// whether there is one.
NumberedWarnings rest_warnings(const Summary& summary);

}  // namespace upbead
