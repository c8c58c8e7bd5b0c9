// The stages of construction, as a summary has them.
#pragma once

#include <optional>

#include "fem/rest_state.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// What came of building the section in stages; none where it is not built so.
std::optional<ConstructionSummary> construction_of(const Simulation& simulation, const RestState& rest);

/// The same, where no rest state was sought yet: without soil that fails it is that of elastic ground.
std::optional<ConstructionSummary> build(const Simulation& simulation);

}  // namespace upbead
