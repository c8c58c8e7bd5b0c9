// Whether the ground stands at rest, by which factor its strength may fall, and what follows for all other results.
#pragma once

#include <optional>

#include "upbead/run/simulation.h"

namespace upbead {

/// Where the scene asks for it, and where `so_far` has no rest of soil that fails.
std::optional<SafetySummary> find_safety(const Simulation& simulation, const Summary& so_far);

/// Puts the check of the ground at rest before all others, and its warnings: no_rest, where there is no state at rest,
/// and rest_open, where it is not known whether there is one. Without one all other checks so far, which come of
/// marches from there, are void.
void judge_rest(const Scene& scene, Summary& summary);

}  // namespace upbead
