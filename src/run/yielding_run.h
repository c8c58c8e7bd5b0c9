// Runs of scenes whose soil yields.
#pragma once

#include <functional>

#include "upbead/run/simulation.h"

namespace upbead {

/// Follows a march from the start that the scene asks for; the scheme lives no longer than that march.
struct YieldingFollower {
  std::function<MarchObserver*(const Scheme&)> begin;  ///< null: no observer
  std::function<ContactSolution()> end;                ///< what the nodes of an interface did
  SoilFollower soil;                                   ///< see RunOptions::soil
};

struct YieldingRunOptions {
  bool bounds = true;  ///< bounds from other starts, where the scene wants them
  YieldingFollower follower;
};

/// Marches by make_yielding_scheme, from the start that the scene asks for; then, where the scene wants bounds, from
/// the other two starts. Where the system has an interface, its nodes slip and lift. Throws NumericsError where the
/// soil finds no equilibrium.
Solution run_yielding(const Simulation& simulation, const MarchOptions& marching,
                      const std::function<void(double)>& progress, const YieldingRunOptions& options = {});

}  // namespace upbead
