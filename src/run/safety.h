// The factor by which the strength of the soils may fall at rest.
#pragma once

#include <optional>

#include "upbead/run/simulation.h"

namespace upbead {

/// Only where the scene asks for it (initial.safety).
std::optional<SafetySummary> find_safety(const Simulation& simulation);

}  // namespace upbead
