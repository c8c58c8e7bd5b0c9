// The course in time of a standing wave of finite height on a wall, as a row of pressures.
#pragma once

#include "upbead/base/time_function.h"
#include "upbead/model/gauges.h"
#include "upbead/waves/standing_wave.h"

namespace upbead {

/// Course: the water rests, a trough grows within T/2, the wave stands for a whole T from where P rises through zero,
/// and dies away within T/2. All values are the excess over still water, without the load's factor.
struct StandingLoad {
  StandingWave wave;
  StandingExtremes extremes;
  Gauges gauges;        ///< on the front, by heights above still water; with the force and moment of wall_pressure()
  TimeFunction force;   ///< P(t) (N/m)
  TimeFunction uplift;  ///< U(t) >= 0 (N/m)
  double peak_uplift = 0.;
  double end = 0.;  ///< when it is over, 2 T (s)
};

/// Throws NumericsError where there is no such wave.
StandingLoad standing_load(const DesignWave& wave, const Section& section, const Water& water);

}  // namespace upbead
