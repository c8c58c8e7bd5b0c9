// S by every measure: by formulas on the history of F_T, and of a caisson that slips as a whole on its ground.
#pragma once

#include <functional>

#include "upbead/run/simulation.h"

namespace upbead {

/// Reads the sliding of a glued run, with [sliding]; else there is none. Where the caisson never reaches its friction
/// the coupled S is zero without more work; else the scene is compiled with an interface and reduced, which leaves a
/// history.
void read_sliding(const Simulation& simulation, Run& run, const std::function<void(double)>& progress);

/// A run without contact of the same scene with other sliding: what was solved is kept. Throws InputError at keys of
/// the scene.
Run with_sliding(const Run& run, const Scene& given, const std::function<void(double)>& progress);

/// no_coupled_slip: the coupled S would not be right.
NumberedWarnings slip_warnings(const SlidingSummary& sliding);

/// Why there was nothing to compute, where that is so.
std::vector<Skipped> skipped(const SlidingSummary& sliding);

}  // namespace upbead
