#include "upbead/waves/standing_stability.h"

#include <algorithm>
#include <cmath>

#include "upbead/base/error.h"
#include "upbead/waves/edge_pressures.h"
#include "upbead/waves/wave_heights.h"

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

/// Stability seaward: seen from the sea the section's heel is its toe, and the harbour is in front. `still.weight` then
/// has its line 2B/3 from the edge about which it turns, where stability() takes B/3. Under the base the pressure falls
/// by a triangle that is largest at the toe. That suction holds the caisson, and is left out where it slides or turns;
/// but it also presses the toe on the mound, S = -p_u B/2 at B/3 from the toe: p_e is the larger one of both, as nobody
/// knows how far suction comes under the base.
Stability seaward(Section section, const Water& water, const WallPressure& trough, double factor) {
  StillWater still = still_water(section, water);
  const double W = section.submerged_weight + still.weight, B = section.width;
  const double t = section.centroid.value_or(0.5 * B);
  section.centroid = (section.submerged_weight * (B - t) + still.weight * 2. / 3. * B) / W;
  section.submerged_weight = W;
  still = {-still.push, -still.push_moment, 0.};
  WavePressure pressure = resultants(trough, B, factor);
  pressure.uplift_moment = pressure.uplift * B / 3.;  // about the toe, where it is largest
  Stability s = stability(section, pressure, still);
  still.weight = -0.5 * B * factor * std::min(trough.edge_pressure, 0.);
  const std::optional<double> sucked = stability(section, pressure, still).heel_pressure;
  if (above_all(sucked) > above_all(s.heel_pressure)) s.heel_pressure = sucked;
  return s;
}

/// Integrals of rho g min(z, H + (H / cosh(kh) - H) (z - H)/(h - H)) over the depth z from 0 to h': force, and moment
/// about z = h'.
WallPressure sainflou_trough(const Section& section, const Water& water, double H, double kh) {
  const double h = section.water_depth, foot = section.foundation_depth, unit_weight = water.density * water.gravity;
  const double knee = std::min(H, std::min(foot, h)), below = foot - knee;
  const double bed = knee < H ? knee : H / std::cosh(kh);  // over rho g
  const double at_foot = h > knee ? knee + (bed - knee) * std::min(below / (h - knee), 1.) : knee;
  WallPressure at;
  at.force = -unit_weight * (0.5 * knee * knee + 0.5 * (knee + at_foot) * below);
  at.force_moment =
      -unit_weight * (0.5 * knee * knee * (below + knee / 3.) + (2. * knee + at_foot) * below * below / 6.);
  at.edge_pressure = -unit_weight * at_foot;
  return at;
}

}  // namespace

TroughBound trough_bound(const Section& section, const Water& water, const DesignWave& wave, double factor) {
  const double kh = relative_wave_number(wave.period, section.water_depth, water.gravity);
  const WallPressure trough = sainflou_trough(section, water, wave.height, kh);
  return {factor * -trough.force, factor * -trough.force_moment, seaward(section, water, trough, factor)};
}

StandingResult standing_answer(const Section& section, const Water& water, const DesignWave& wave, double factor,
                               const StandingWave* lower) {
  const auto none = [&](const std::string& why) {
    return StandingResult{{}, why, trough_bound(section, water, wave, factor)};
  };
  if (wave.angle != 0.) return none("the wave does not come straight at the wall");
  if (section.dissipating_blocks) return none("wave-dissipating blocks leave no standing wave");
  try {
    const StandingWave standing({section.water_depth, wave.height, wave.period}, water, lower);
    StandingAnswer a{
        standing.wavelength(), standing.residual(), standing_extremes(standing, section), {}, {}, standing};
    a.landward = stability(section, resultants(a.worst.landward, section.width, factor), still_water(section, water));
    a.seaward = seaward(section, water, a.worst.seaward, factor);
    return {a, ""};
  } catch (const NumericsError& error) {
    return none(error.what());
  }
}

}  // namespace upbead
