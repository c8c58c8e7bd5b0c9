// Still water at two levels beside a wall: hydrostatics, which the formulas for waves and the scene at rest share.
#pragma once

#include <algorithm>

namespace upbead {

/// What still water that stands at two levels does to a caisson, beside W' in water as high as the sea: hydrostatic
/// pressure on both walls, and under the base a pressure that falls in a straight line from one level to the other.
struct StillWater {
  double push = 0.;         ///< landward (N/m)
  double push_moment = 0.;  ///< about the bottom's level, overturning landward positive (N m/m)
  double weight = 0.;       ///< by which W' is larger (N/m); its line is B/3 from the heel, as of a triangle
};

/// `front`, `back`: height of the sea and of the harbour above the caisson's bottom, width B (m); one below the bottom
/// counts as 0. `unit_weight`: rho g (N/m3).
inline StillWater still_water(double front, double back, double width, double unit_weight) {
  const double f = std::max(front, 0.), b = std::max(back, 0.);
  return {0.5 * unit_weight * (f * f - b * b), unit_weight * (f * f * f - b * b * b) / 6.,
          0.5 * unit_weight * width * (f - b)};
}

}  // namespace upbead
