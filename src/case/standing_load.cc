#include "case/standing_load.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/numbers.h"
#include "base/root.h"

namespace upbead {

namespace {

/// Samples per period: with P linear between them, the error is 3e-4 of its amplitude, (2 pi/256)^2/8 for four
/// harmonics.
constexpr int samples = 256;

/// Share of the full wave that has built up at a time t of the run.
double share_of_wave(double t, double T) {
  if (t < 0.5 * T) return std::pow(std::sin(pi * t / T), 2);
  return t > 1.5 * T ? std::pow(std::cos(pi * (t - 1.5 * T) / T), 2) : 1.;
}

/// Time of the wave, before its crest at the wall, at which P rises through zero.
double rise_through_zero(const StandingWave& wave, const Section& section, const StandingExtremes& extremes) {
  const auto force = [&](double t) { return wall_pressure(wave, section, t).force; };
  const auto [from, to] =
      root_bracket(force, -0.5 * wave.period(), -std::abs(extremes.landward.time), std::numeric_limits<double>::digits);
  return 0.5 * (from + to);
}

/// Equally spaced samples and, while the wave stands, the times of the extremes; `zero`: time of the wave at the
/// run's t = T/2.
std::vector<double> times_of(const StandingExtremes& extremes, double zero, double T) {
  std::vector<double> times;
  for (int i = 0; i <= 2 * samples; ++i) times.push_back(i * T / samples);
  for (const double worst :
       {extremes.landward.time, -extremes.landward.time, extremes.seaward.time, T - extremes.seaward.time})
    if (const double t = worst - zero + 0.5 * T; t > 0.5 * T && t < 1.5 * T) times.push_back(t);
  std::sort(times.begin(), times.end());
  const double same = 1e-6 * T;
  times.erase(std::unique(times.begin(), times.end(), [same](double a, double b) { return b - a < same; }),
              times.end());
  return times;
}

}  // namespace

StandingLoad standing_load(const DesignWave& given, const Section& section, const Water& water) {
  StandingLoad load{StandingWave({section.water_depth, given.height, given.period}, water), {}, {}, {}, {}, 0., 0.};
  load.end = 2. * given.period;
  load.extremes = standing_extremes(load.wave, section);
  const double T = given.period, zero = rise_through_zero(load.wave, section, load.extremes);
  Gauges& gauges = load.gauges;
  gauges.beyond = {Beyond::none, Beyond::none};
  gauges.place = wall_heights(load.wave, section);
  gauges.pressure.resize(gauges.place.size());
  for (std::size_t i = 0; i < gauges.place.size(); ++i)
    gauges.name.push_back((i < 9 ? "0" : "") + std::to_string(i + 1));
  gauges.time = times_of(load.extremes, zero, T);
  std::vector<double> force, uplift;
  for (const double t : gauges.time) {
    const double share = share_of_wave(t, T), of_wave = t - 0.5 * T + zero;
    const std::vector<double> pressure = wall_pressures(load.wave, gauges.place, of_wave);
    for (std::size_t i = 0; i < pressure.size(); ++i) gauges.pressure[i].push_back(share * pressure[i]);
    const WallPressure at = wall_pressure(load.wave, section, of_wave);
    force.push_back(share * at.force);
    uplift.push_back(share * at.uplift);
  }
  load.force = piecewise_linear(gauges.time, force);
  load.peak_uplift = *std::max_element(uplift.begin(), uplift.end());
  load.uplift = piecewise_linear(gauges.time, uplift);
  return load;
}

}  // namespace upbead
