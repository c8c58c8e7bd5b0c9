#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "model/words.h"
#include "upbead/model/load.h"

namespace upbead {

namespace {

using Shapes = std::vector<PulseShape>;
using S = PulseShape;

/// Which shapes need an optional member, and which others may have it.
struct PulseRule {
  std::string key;
  std::optional<double> Pulse::*member;
  Shapes needed;
  Shapes allowed;
};

const std::vector<PulseRule> pulse_rules{
    {"rise", &Pulse::rise, {}, {S::triangle, S::step, S::church_roof}},
    {"duration", &Pulse::duration, {S::triangle, S::half_sine, S::church_roof}, {}},
    {"plateau", &Pulse::plateau, {S::church_roof}, {}},
    {"plateau_duration", &Pulse::plateau_duration, {S::church_roof}, {}},
    {"frequency", &Pulse::frequency, {S::harmonic}, {}},
};

bool holds(const Shapes& shapes, PulseShape shape) {
  return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
}

double rise_of(const Pulse& pulse) {
  if (pulse.rise) return *pulse.rise;
  return pulse.shape == S::step ? 0. : 0.5 * *pulse.duration;
}

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

std::vector<Objection> objections(const Pulse& pulse) {
  std::vector<Objection> list;
  const std::string shape = word_of(pulse.shape, pulse_shape_words);
  if (pulse.peak == 0.) list.push_back({"peak", "peak is zero, so there is no load", "give the largest value"});
  for (const PulseRule& rule : pulse_rules) {
    const bool given = (pulse.*rule.member).has_value(), needed = holds(rule.needed, pulse.shape);
    if (needed && !given)
      list.push_back({rule.key, "'" + rule.key + "' is missing, which shape " + shape + " needs", "add " + rule.key});
    if (given && !needed && !holds(rule.allowed, pulse.shape))
      list.push_back({rule.key, "'" + rule.key + "' does not belong to shape " + shape, "remove it"});
  }
  if (!list.empty()) return list;
  if (pulse.duration && pulse.rise && *pulse.rise > *pulse.duration)
    list.push_back({"rise", "rise is longer than duration", "give a rise within the duration"});
  if (pulse.plateau_duration && *pulse.plateau_duration <= *pulse.duration)
    list.push_back({"plateau_duration", "plateau_duration is not longer than duration",
                    "give the time from start until the slow part has gone"});
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

std::optional<double> duration(const Pulse& pulse) {
  if (pulse.shape == S::half_sine) return pulse.duration;
  if (pulse.shape == S::harmonic) return 0.5 / *pulse.frequency;
  return {};
}

}  // namespace upbead
