// The ways that were tried to solve a scene.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// One way, and why its answer was not taken.
struct LadderStep {
  std::string way;      ///< for people: "reduced", "sdirk4", "sdirk4, steps of 0.001 s"
  std::string refused;  ///< the reason with its numbers; "" where it was taken
};

/// In the order in which they were tried; the last one was taken.
using Ladder = std::vector<LadderStep>;

}  // namespace upbead
