// The sliding distance of the caisson of a case.
#pragma once

#include "fem/compile.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Throws InputError where [sliding] does not fit the caisson: a weight that differs from its mass by more than 1 %,
/// W' not below W, an uplift by pore pressure where no pore water reaches the bottom.
void check_sliding(const Simulation& simulation);

/// U(t) of a prescribed uplift, straight between these times and its own kinks and samples (N/m).
TimeFunction sampled_uplift(const Scene& scene, const CompiledScene& compiled, const std::vector<double>& time);

/// None where there is no [sliding].
std::optional<SlidingSummary> sliding_of(const Scene& scene, const CompiledScene& compiled, const Response& response);

}  // namespace upbead
