// Runs of scenes whose soil yields.
#pragma once

#include <functional>

#include "run/solve.h"

namespace upbead {

/// Follows the nodes of an interface in a march from the start that the scene asks for; the scheme lives no longer than
/// that march. Both are null where there is none.
struct NodeFollower {
  std::function<MarchObserver*(const Scheme&)> begin{};
  std::function<ContactSolution()> end{};  ///< what the nodes did
};

/// Marches by make_yielding_scheme, from the start that the scene asks for; then, where the scene wants bounds and
/// `bounds` is true, from the other two starts. Where the system has an interface, its nodes slip and lift. Throws
/// NumericsError where the soil finds no equilibrium.
Solution run_yielding(const Simulation& simulation, const Marching& marching, const NodeFollower& nodes = {},
                      bool bounds = true);

}  // namespace upbead
