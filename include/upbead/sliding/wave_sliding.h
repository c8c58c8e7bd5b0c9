// The sliding distance of one wave by the formulas of its height.
#pragma once

#include "upbead/sliding/pulse.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// What slides the caisson in one wave.
struct SlidingLoad {
  double resistance = 0.;  ///< mu W' (N/m)
  double mass = 0.;        ///< W/g (kg/m)
  TriangularPulse pulse;   ///< F_Smax = P + mu U and tau_0 of eqs. (8)-(11)
};

/// The pulse of a wave of height H and period T with the pressures that it makes.
SlidingLoad sliding_load(const Section& section, const Water& water, const WavePressure& pressure, double height,
                         double period, const DurationFactor& k = {});

}  // namespace upbead
