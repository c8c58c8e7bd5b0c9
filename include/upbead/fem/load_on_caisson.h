#pragma once

#include <cmath>
#include <optional>
#include <string>

namespace upbead {

/// Resultant of a load on the caisson per unit of its history.
struct LoadOnCaisson {
  std::string name;
  double force_x = 0., force_y = 0.;  ///< N/m per unit
  double moment = 0.;                 ///< about the bottom's centre, overturning positive (N m/m per unit)

  /// moment / force_x: height above the bottom (m); none without force_x.
  std::optional<double> arm() const {
    return std::abs(force_x) < 1e-12 ? std::nullopt : std::optional(moment / force_x);
  }
};

}  // namespace upbead
