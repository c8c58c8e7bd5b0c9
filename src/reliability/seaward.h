// The force of a standing wave's trough over the height of the wave, for samples that would need a wave each.
#pragma once

#include <functional>
#include <string>

#include "design/design_tables.h"

namespace upbead {

/// P seaward (N/m) over H (m), or why there is none.
struct SeawardForce {
  std::function<double(double height)> of_height;
  double highest = 0.;  ///< H (m) of the highest wave that does not break; higher ones have its force
  std::string why_not;
};

/// Standing waves of finite height (StandingWave) at 16 heights, and Akima's modified interpolation between them. Only
/// where water, wall and period are certain. `tables`: of a design that check_reliability() has accepted.
SeawardForce seaward_force(const DesignTables& tables);

}  // namespace upbead
