#include "upbead/model/load.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "model/member_rules.h"
#include "model/words.h"

namespace upbead {

bool is_motion(LoadKind kind) {
  return kind == LoadKind::displacement || kind == LoadKind::velocity || kind == LoadKind::acceleration;
}

bool is_on_volume(LoadKind kind) {
  return kind == LoadKind::body_force || kind == LoadKind::gravity || kind == LoadKind::source;
}

const char* unit_of(LoadKind kind) {
  switch (kind) {
    case LoadKind::force:
      return "N/m";
    case LoadKind::displacement:
      return "m";
    case LoadKind::velocity:
      return "m/s";
    case LoadKind::acceleration:
    case LoadKind::gravity:
      return "m/s2";
    case LoadKind::body_force:
      return "N/m3";
    case LoadKind::source:
      return "1/s";
    default:
      return "Pa";
  }
}

namespace {

/// Length along a polygon, up to its point that is nearest to (x, y).
double length_along(const std::vector<std::array<double, 2>>& course, double x, double y) {
  double length = 0., nearest = std::numeric_limits<double>::infinity(), along = 0.;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    const double dx = course[i + 1][0] - course[i][0], dy = course[i + 1][1] - course[i][1], l = std::hypot(dx, dy);
    const double s = std::clamp(((x - course[i][0]) * dx + (y - course[i][1]) * dy) / l, 0., l);
    const double away = std::hypot(x - course[i][0] - s / l * dx, y - course[i][1] - s / l * dy);
    if (away < nearest) {
      nearest = away;
      along = length + s;
    }
    length += l;
  }
  return along;
}

}  // namespace

double shape_coordinate(const Load& load, double x, double y) {
  if (load.along_curve) return length_along(load.course, x, y);
  return load.over_x ? x : y;
}

double intensity(const Load& load, double x, double y) {
  if (load.cosine) return std::cos(2. * pi * (x - load.cosine->origin) / load.cosine->length);
  return load.shape.empty() ? 1. : intensity(load, shape_coordinate(load, x, y));
}

double intensity(const Load& load, double at) {
  const auto& shape = load.shape;
  if (shape.empty()) return 1.;
  if (at < shape.front()[0] || at > shape.back()[0]) return 0.;
  for (std::size_t i = 0; i + 1 < shape.size(); ++i) {
    const auto& [low, at_low] = shape[i];
    const auto& [high, at_high] = shape[i + 1];
    if (at <= high) return at_low + (at_high - at_low) * (at - low) / (high - low);
  }
  return shape.back()[1];
}

double sampled_duration(const std::vector<double>& time, const std::vector<double>& value, double end) {
  double peak = 0., steepest = 0.;
  for (std::size_t i = 0; i < time.size(); ++i) {
    peak = std::max(peak, std::abs(value[i]));
    if (i > 0) steepest = std::max(steepest, std::abs((value[i] - value[i - 1]) / (time[i] - time[i - 1])));
  }
  if (peak == 0.) return std::numeric_limits<double>::infinity();
  const double noise = 0.05 * peak;
  if (std::abs(value.front()) > noise || (time.back() < end && std::abs(value.back()) > noise)) return 0.;
  return 2. * peak / steepest;
}

namespace {

using S = PulseShape;

const std::vector<MemberRule<Pulse, PulseShape>> pulse_rules{
    {"rise", {S::triangle, S::step, S::church_roof}, false, is_set(&Pulse::rise)},
    {"duration", {S::triangle, S::half_sine, S::church_roof}, true, is_set(&Pulse::duration)},
    {"plateau", {S::church_roof}, true, is_set(&Pulse::plateau)},
    {"plateau_duration", {S::church_roof}, true, is_set(&Pulse::plateau_duration)},
    {"frequency", {S::harmonic}, true, is_set(&Pulse::frequency)},
};

struct Corner {
  double time = 0.;
  double value = 0.;
};

/// Zero before the first corner, linear between, constant after the last; corners at the same time make a jump.
TimeFunction linear_between(const std::vector<Corner>& corners) {
  std::vector<double> kinks;
  std::vector<TimeFunction::Piece> pieces{[](double) { return 0.; }};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Corner a = corners[i], b = corners[i + 1];
    if (a.time == b.time) continue;
    kinks.push_back(a.time);
    pieces.push_back([a, b](double t) { return a.value + (b.value - a.value) * (t - a.time) / (b.time - a.time); });
  }
  kinks.push_back(corners.back().time);
  pieces.push_back([last = corners.back().value](double) { return last; });
  return TimeFunction(std::move(kinks), std::move(pieces));
}

/// peak sin(omega (t - start)), zero before `start` and after `end`.
TimeFunction sine(const Pulse& pulse, double omega, std::optional<double> end) {
  std::vector<double> kinks{pulse.start};
  const auto zero = [](double) { return 0.; };
  std::vector<TimeFunction::Piece> pieces{
      zero, [peak = pulse.peak, start = pulse.start, omega](double t) { return peak * std::sin(omega * (t - start)); }};
  if (end) {
    kinks.push_back(*end);
    pieces.emplace_back(zero);
  }
  return TimeFunction(std::move(kinks), std::move(pieces));
}

}  // namespace

Diagnostics diagnose(const Pulse& pulse) {
  Diagnostics list;
  if (pulse.peak == 0.) list.add(at_key("peak"), "peak is zero, so there is no load", "give the largest value");
  list.add(diagnose_members(pulse_rules, pulse, pulse.shape, "shape " + word_of(pulse.shape, pulse_shape_words)));
  if (!list.empty()) return list;
  if (pulse.duration && pulse.rise && *pulse.rise > *pulse.duration)
    list.add(at_key("rise"), "rise is longer than duration", "give a rise within the duration");
  if (pulse.plateau_duration && *pulse.plateau_duration <= *pulse.duration)
    list.add(at_key("plateau_duration"), "plateau_duration is not longer than duration",
             "give the time from start until the slow part has gone");
  return list;
}

TimeFunction time_function(const Pulse& pulse) {
  const double start = pulse.start, peak = pulse.peak;
  switch (pulse.shape) {
    case S::triangle:
      return linear_between({{start, 0.}, {start + rise_of(pulse), peak}, {start + *pulse.duration, 0.}});
    case S::step:
      return linear_between({{start, 0.}, {start + rise_of(pulse), peak}});
    case S::church_roof:
      return linear_between({{start, 0.},
                             {start + rise_of(pulse), peak},
                             {start + *pulse.duration, *pulse.plateau * peak},
                             {start + *pulse.plateau_duration, 0.}});
    case S::half_sine:
      return sine(pulse, pi / *pulse.duration, start + *pulse.duration);
    case S::harmonic:
      return sine(pulse, 2. * pi * *pulse.frequency, {});
  }
  return {};
}

double rise_of(const Pulse& pulse) {
  if (pulse.rise) return *pulse.rise;
  if (pulse.shape == S::harmonic) return 0.25 / *pulse.frequency;
  return pulse.shape == S::step ? 0. : 0.5 * *pulse.duration;
}

std::optional<double> duration(const Pulse& pulse) {
  if (pulse.shape == S::half_sine) return pulse.duration;
  if (pulse.shape == S::harmonic) return 0.5 / *pulse.frequency;
  return {};
}

}  // namespace upbead
