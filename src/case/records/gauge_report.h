// What transducers measured, for people and for the summary.
#pragma once

#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Of all loads by transducers and of the uplift; forces and arms are those on the caisson of the scene.
std::vector<GaugeSummary> gauge_summaries(const Case& input, const Simulation& simulation);

std::string describe(const std::vector<GaugeSummary>& gauges);

/// Warnings of all transducers (model/gauges.h).
NumberedWarnings gauge_warnings(const Case& input, const Simulation& simulation);

}  // namespace upbead
