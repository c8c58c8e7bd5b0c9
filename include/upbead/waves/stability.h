// Conventional safety of the caisson against one wave.
#pragma once

#include <optional>

#include "upbead/waves/goda.h"

namespace upbead {

struct Stability {
  double safety_sliding = 0.;      ///< mu (W' - U) / P
  double safety_overturning = 0.;  ///< (W' t - M_U) / M_P
  double toe_pressure = 0.;        ///< p_e, largest pressure under the heel (Pa); negative where it overturns
  double sliding_force = 0.;       ///< F_Smax = P + mu U (N/m)
  double resistance = 0.;          ///< mu W' (N/m)
  double ratio = 0.;               ///< r = F_Smax / (mu W'); not 1/S.F. unless U = 0
};

Stability stability(const Section& section, const WavePressure& pressure);

/// Buoyant weight W' (N/m) that gives the safety factor against sliding that is asked for.
double buoyant_weight_for(double safety_sliding, double friction, const WavePressure& pressure);

}  // namespace upbead
