// Solving a case whose caisson may slip and lift, node by node.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Solves the scene glued first, which tells S by other measures, too. Where no node reaches its friction or pulls,
/// that is the answer; else it is marched with the law of contact. The system must have an interface; the run's
/// simulation is the one that its answer belongs to. Throws NumericsError.
Run run_contact(const Simulation& simulation, const MarchOptions& marching,
                const std::function<void(double)>& progress);

}  // namespace upbead
