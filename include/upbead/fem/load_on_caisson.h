#pragma once

#include <optional>
#include <string>

namespace upbead {

/// Resultant of a load on the caisson per unit of its history.
struct LoadOnCaisson {
  std::string name;
  double force_x = 0., force_y = 0.;  ///< N/m per unit
  double moment = 0.;                 ///< about the bottom's centre, overturning positive (N m/m per unit)
  std::optional<double> arm() const;  ///< moment / force_x: height above the bottom (m); none without force_x
};

}  // namespace upbead
