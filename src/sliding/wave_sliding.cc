#include "upbead/sliding/wave_sliding.h"

namespace upbead {

SlidingLoad sliding_load(const Section& section, const Water& water, const WavePressure& pressure, double height,
                         double period, const DurationFactor& k) {
  const Stability s = stability(section, pressure);
  const double tau_0 = k(pressure.alpha_star) * standing_duration(height, section.water_depth, period);
  return {s.resistance, section.weight / water.gravity, {s.sliding_force, tau_0}};
}

}  // namespace upbead
