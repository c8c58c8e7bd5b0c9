// Runs of scenes whose soil yields.
#pragma once

#include <functional>

#include "upbead/run/simulation.h"

namespace upbead {

/// Follows a march from the start that the scene asks for, by a scheme that lives no longer.
struct YieldingFollower {
  std::function<MarchObserver*(const Scheme&)> begin;  ///< null: nothing to show
  std::function<void(Run&)> end;
  SoilFollower soil;  ///< see RunOptions::soil
};

struct YieldingRunOptions {
  bool bounds = true;  ///< where the scene wants them
  YieldingFollower follower;
};

/// Marched by make_yielding_scheme, from the start that the scene asks for; then, where it wants bounds, from the other
/// two. Where the system has an interface, its nodes slip and lift. Throws NumericsError where the soil finds no
/// equilibrium.
Run run_yielding(const Simulation& simulation, const MarchOptions& marching,
                 const std::function<void(double)>& progress, const YieldingRunOptions& options = {});

}  // namespace upbead
