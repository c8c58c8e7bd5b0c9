// Runs of scenes whose soil yields.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Marched by make_yielding_scheme, from the start that the scene asks for; then, where it wants bounds, from the other
/// two. `follow`: see RunOptions::soil. Throws NumericsError where the soil finds no equilibrium.
Run run_yielding(const Simulation& simulation, const MarchOptions& marching,
                 const std::function<void(const YieldingSoil&)>& follow, const std::function<void(double)>& progress);

}  // namespace upbead
