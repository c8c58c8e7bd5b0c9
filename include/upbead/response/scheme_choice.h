// How a scene is solved in time where the case leaves it to us.
#pragma once

#include <string>

#include "upbead/fem/compile.h"

namespace upbead {

struct SchemeChoice {
  TimeScheme scheme = TimeScheme::sdirk4;  ///< never automatic
  std::string reason;                      ///< for people, with the numbers
};

/// A reduced model where it takes less work than marching and gives all that the case asks for: measured, a vector of
/// its space costs as much as 1.5 solves of a march. A stated scheme is always kept.
SchemeChoice choose_scheme(const Scene& scene, const CompiledScene& compiled);

}  // namespace upbead
