// S by every measure: by formulas on the history of F_T, and of a caisson that slips as a whole on its ground.
#pragma once

#include <functional>

#include "upbead/app/pipeline.h"

namespace upbead {

/// Reads the sliding of a glued run, with [sliding]; else there is none. Where the caisson never reaches its friction
/// the coupled S is zero without more work; else the scene is compiled with an interface and reduced, which leaves a
/// history.
void read_sliding(const Case& input, const CompiledCase& scene, Run& run, const std::function<void(double)>& progress);

/// no_coupled_slip: the coupled S would not be right.
NumberedWarnings slip_warnings(const SlidingSummary& sliding);

/// Why there was nothing to compute, where that is so.
std::vector<Skipped> skipped(const SlidingSummary& sliding);

}  // namespace upbead
