#include "upbead/waves/standing_stability.h"

#include <algorithm>
#include <cmath>

#include "upbead/base/error.h"

namespace upbead {

namespace {

WavePressure resultants(const WallPressure& at, double width, double factor) {
  WavePressure p;
  p.force = factor * std::abs(at.force);
  p.force_moment = factor * std::abs(at.force_moment);
  p.pu = factor * std::max(at.edge_pressure, 0.);
  p.uplift = factor * at.uplift;
  p.uplift_moment = 2. / 3. * p.uplift * width;
  return p;
}

/// The section seen from the sea: its heel is the toe.
Section mirrored(Section section) {
  if (section.centroid) section.centroid = section.width - *section.centroid;
  return section;
}

}  // namespace

StandingResult standing_answer(const Section& section, const Water& water, const DesignWave& wave, double factor) {
  if (wave.angle != 0.) return {{}, "the wave does not come straight at the wall"};
  if (section.dissipating_blocks) return {{}, "wave-dissipating blocks leave no standing wave"};
  try {
    const StandingWave standing({section.water_depth, wave.height, wave.period}, water);
    StandingAnswer a{standing.wavelength(), standing.residual(), standing_extremes(standing, section), {}, {}};
    a.landward = stability(section, resultants(a.worst.landward, section.width, factor));
    WallPressure trough = a.worst.seaward;
    trough.uplift = trough.edge_pressure = 0.;
    a.seaward = stability(mirrored(section), resultants(trough, section.width, factor));
    return {a, ""};
  } catch (const NumericsError& error) {
    return {{}, error.what()};
  }
}

}  // namespace upbead
