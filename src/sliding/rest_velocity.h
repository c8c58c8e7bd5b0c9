// When a caisson that still slides is as good as at rest.
#pragma once

#include <cmath>

namespace upbead {

constexpr double tolerable_rest = 0.01;  ///< of S

/// The velocity (m/s) from which full friction brakes the caisson within a tolerable part of S: v^2 = 2 mu g s.
inline double tolerable_velocity(double friction, double gravity, double S) {
  return std::sqrt(2. * friction * gravity * tolerable_rest * std::abs(S));
}

}  // namespace upbead
