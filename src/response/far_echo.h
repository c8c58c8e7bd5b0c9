// When the far sides of a mesh are felt.
#pragma once

#include <optional>
#include <string>

#include "fem/space.h"

namespace upbead {

struct FarEcho {
  std::string side;
  double distance = 0.;    ///< from the side to the nearest of all that is not only ground going on (m)
  double speed = 0.;       ///< of shear waves in the ground behind it, mean over its area (m/s)
  bool absorbing = false;  ///< it lets waves out, but not all
  double time() const { return 2. * distance / speed; }  ///< that shear waves take there and back (s)
};

/// The far side that is felt first, of the upright sides where the ground ends; those of water alone are not felt
/// (docs/sides.md), and absorbing ones of dry ground are good enough. Distances are from the toe of the mound, or from
/// what else stands on the ground. None without a caisson. `scene` as solved, of which the space is.
std::optional<FarEcho> first_echo(const Scene& scene, const Space& space);

}  // namespace upbead
