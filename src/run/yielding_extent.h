// Which parts of a scene may yield, and which stay linear and why.
#pragma once

#include <vector>

#include "upbead/run/simulation.h"

namespace upbead {

struct YieldingExtent {
  int cells = 0;                ///< that may yield
  double area = 0.;             ///< of them (m2)
  int of = 0;                   ///< all cells that deform
  std::vector<Skipped> linear;  ///< regions that stay linear, and why
};

YieldingExtent yielding_extent(const Simulation& simulation);

}  // namespace upbead
