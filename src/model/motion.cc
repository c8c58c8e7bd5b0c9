#include "model/motion.h"

#include <math.h>  // isnan, which Boost 1.74 expects in the global namespace

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <memory>

#include "base/numbers.h"

namespace upbead {

namespace {

double zero(double) {
  return 0.;
}

/// Piecewise constant: values[i] between kinks[i] and kinks[i + 1]; zero before and after.
TimeFunction steps(const std::vector<double>& kinks, const std::vector<double>& values) {
  std::vector<TimeFunction::Piece> pieces{zero};
  for (const double value : values) pieces.emplace_back([value](double) { return value; });
  pieces.emplace_back(zero);
  return TimeFunction(kinks, std::move(pieces));
}

/// peak omega cos(omega (t - start)) from `start` to `end`, or for ever without an end.
TimeFunction rate_of_sine(const Pulse& pulse, double omega, std::optional<double> end) {
  std::vector<double> kinks{pulse.start};
  std::vector<TimeFunction::Piece> pieces{zero, [a = pulse.peak * omega, start = pulse.start, omega](double t) {
                                            return a * std::cos(omega * (t - start));
                                          }};
  if (end) {
    kinks.push_back(*end);
    pieces.emplace_back(zero);
  }
  return TimeFunction(std::move(kinks), std::move(pieces));
}

/// Velocity of a displacement that follows a pulse without jumps.
TimeFunction rate(const Pulse& pulse) {
  const double start = pulse.start, rise = rise_of(pulse), peak = pulse.peak;
  switch (pulse.shape) {
    case PulseShape::step:
      return steps({start, start + rise}, {peak / rise});
    case PulseShape::triangle:
      return steps({start, start + rise, start + *pulse.duration}, {peak / rise, -peak / (*pulse.duration - rise)});
    case PulseShape::church_roof:
      return steps({start, start + rise, start + *pulse.duration, start + *pulse.plateau_duration},
                   {peak / rise, -(1. - *pulse.plateau) * peak / (*pulse.duration - rise),
                    -*pulse.plateau * peak / (*pulse.plateau_duration - *pulse.duration)});
    case PulseShape::half_sine:
      return rate_of_sine(pulse, pi / *pulse.duration, start + *pulse.duration);
    case PulseShape::harmonic:
      return rate_of_sine(pulse, 2. * pi * *pulse.frequency, {});
  }
  return {};
}

/// Velocity from the acceleration f, from rest at t = 0.
TimeFunction integrated(const TimeFunction& f) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  std::vector<TimeFunction::Piece> pieces;
  double begin = 0., reached = 0.;
  const std::vector<double>& kinks = f.kinks();
  for (std::size_t i = 0; i <= kinks.size(); ++i) {
    const double end = i < kinks.size() ? kinks[i] : begin + 1.;
    const auto piece = f.piece(0.5 * (begin + end));
    const auto velocity = [piece, begin, reached](double t) {
      return t == begin ? reached : reached + Rule::integrate(piece, begin, t, 10, 1e-12);
    };
    if (end <= begin) {  // at rest before t = 0
      pieces.emplace_back(zero);
      continue;
    }
    pieces.emplace_back(velocity);
    if (i == kinks.size()) break;
    reached = velocity(end);
    begin = end;
  }
  return TimeFunction(kinks, std::move(pieces));
}

}  // namespace

bool jumps(const Pulse& pulse) {
  if (pulse.shape == PulseShape::half_sine || pulse.shape == PulseShape::harmonic) return false;
  const bool at_end = pulse.shape != PulseShape::step && pulse.duration && rise_of(pulse) >= *pulse.duration;
  return rise_of(pulse) == 0. || at_end;
}

TimeFunction velocity(LoadKind kind, const Pulse& pulse) {
  if (kind == LoadKind::displacement) return rate(pulse);
  return kind == LoadKind::acceleration ? integrated(time_function(pulse)) : time_function(pulse);
}

std::optional<double> motion_duration(LoadKind kind, const Pulse& pulse) {
  if (kind != LoadKind::displacement || duration(pulse)) return duration(pulse);
  double shortest = infinity;  // the jumps of the velocity are corners of the displacement
  const std::vector<double> corners = rate(pulse).kinks();
  for (std::size_t i = 1; i < corners.size(); ++i) shortest = std::min(shortest, corners[i] - corners[i - 1]);
  return 2. * shortest;
}

TimeFunction rate_of_samples(const std::vector<double>& time, const std::vector<double>& value) {
  using Curve = boost::math::interpolators::pchip<std::vector<double>>;
  const auto curve = std::make_shared<const Curve>(std::vector<double>(time), std::vector<double>(value));
  const double first = time.front(), last = time.back();
  const auto velocity = [curve, first, last](double t) { return curve->prime(std::clamp(t, first, last)); };
  return TimeFunction({first, last}, {zero, velocity, zero}, time);
}

TimeFunction integral_of_samples(const std::vector<double>& time, const std::vector<double>& value) {
  struct Samples {
    std::vector<double> time, acceleration, velocity;
  };
  const auto of = std::make_shared<Samples>(Samples{time, value, {0.}});
  for (std::size_t i = 0; i + 1 < time.size(); ++i)
    of->velocity.push_back(of->velocity.back() + 0.5 * (value[i] + value[i + 1]) * (time[i + 1] - time[i]));
  const auto velocity = [of](double t) {
    const auto above = std::upper_bound(of->time.begin() + 1, of->time.end() - 1, t) - of->time.begin();
    const auto i = static_cast<std::size_t>(above) - 1;
    const double since = std::clamp(t, of->time.front(), of->time.back()) - of->time[i];
    const double slope = (of->acceleration[i + 1] - of->acceleration[i]) / (of->time[i + 1] - of->time[i]);
    return of->velocity[i] + since * (of->acceleration[i] + 0.5 * slope * since);
  };
  const double last = of->velocity.back();
  return TimeFunction({time.front(), time.back()}, {zero, velocity, [last](double) { return last; }}, time);
}

}  // namespace upbead
