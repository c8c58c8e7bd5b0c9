// How a soil's stiffness depends on its effective stress.
#pragma once

#include <optional>

namespace upbead {

/// G = reference (sigma'_m / pressure)^exponent with the mean effective stress sigma'_m = (s'_x + s'_y + s'_z)/3 of the
/// static state; Richart, Hall and Woods (1970) have exponent 0.5 for sands.
struct StressLaw {
  double reference = 0.;   ///< G at `pressure` (Pa)
  double pressure = 98e3;  ///< Pa
  double exponent = 0.5;
  /// Least sigma'_m that counts (Pa), as G vanishes at free surfaces; none: a tenth of the region's mean, so that
  /// similar scenes stay similar.
  std::optional<double> floor;
};

/// G (Pa) at a mean effective stress (Pa), not below the floor.
double shear_modulus(const StressLaw& law, double stress, double floor);

/// The state before the waves.
struct InitialState {
  std::optional<double> water_level;  ///< height y of still water (m); none: the top of the regions of water
  std::optional<double> k0;           ///< s'_x = s'_z = K_0 s'_y; none: all from the elastic solution
};

}  // namespace upbead
