// How a scene is solved in time where the case leaves it to us.
#pragma once

#include <optional>
#include <string>

#include "fem/compile.h"

namespace upbead {

struct SchemeChoice {
  TimeScheme scheme = TimeScheme::sdirk4;  ///< never automatic
  std::string reason;                      ///< for people, with the numbers
  std::optional<int> most_vectors;         ///< per load: a reduced model that has not converged by then gives up
};

/// A reduced model where it takes less work than marching and gives all that the case asks for; a stated scheme is
/// always kept.
SchemeChoice choose_scheme(const Scene& scene, const CompiledScene& compiled);

}  // namespace upbead
