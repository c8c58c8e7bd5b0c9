// S of a caisson that slips as a whole, with the dynamics of its ground.
#pragma once

#include <functional>

#include "upbead/app/pipeline.h"

namespace upbead {

/// Adds `coupled` to the run's sliding, and its history: of a glued run with [sliding]. Where the glued caisson never
/// reaches its friction S is zero without more work; else the scene is compiled with an interface and reduced.
void add_coupled_sliding(const CompiledCase& scene, Run& run, const std::function<void(double)>& progress);

/// Why there was nothing to compute, where that is so.
std::vector<Skipped> skipped(const SlidingSummary& sliding);

}  // namespace upbead
