// How far the caisson of a case slides.
#pragma once

#include "fem/compile.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Throws InputError where [sliding] does not fit the caisson: another weight than its mass has by more than 1 %, W'
/// not below W, an uplift of pore pressure where the bottom meets none.
void check_sliding(const Simulation& simulation);

/// U(t) of a prescribed uplift, straight between times of which these are the least (N/m).
TimeFunction sampled_uplift(const Scene& scene, const CompiledScene& compiled, const std::vector<double>& time);

/// None without [sliding].
std::optional<SlidingSummary> sliding_of(const Scene& scene, const CompiledScene& compiled, const Response& response);

}  // namespace upbead
