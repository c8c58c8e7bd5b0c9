// By which factor the soils' strength may fall at rest.
#pragma once

#include <optional>

#include "upbead/run/simulation.h"

namespace upbead {

/// Where the scene asks for it (initial.safety).
std::optional<SafetySummary> find_safety(const Simulation& simulation);

}  // namespace upbead
