#include "random_records.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace upbead::test {

namespace {

constexpr double pi = 3.14159265358979323846;

double triangle(double t, double start, double duration, double rise) {
  return std::max(0., std::min((t - start) / rise, (start + duration - t) / (duration - rise)));
}

/// Starts, durations, rises and heights.
using Pulses = std::vector<std::array<double, 4>>;

double sum(const Pulses& pulses, double t) {
  double f = 0.;
  for (const auto& [start, duration, rise, height] : pulses) f += height * triangle(t, start, duration, rise);
  return f;
}

/// A sum of sines whose amplitude grows and falls within `length`.
struct Swing {
  std::vector<std::array<double, 3>> waves;  ///< omega, phase, size
  double length;
  double operator()(double t) const {
    if (t <= 0. || t >= length) return 0.;
    double f = 0.;
    for (const auto& [omega, phase, size] : waves) f += size * std::sin(omega * t + phase);
    return f * std::pow(std::sin(pi * t / length), 2);
  }
};

}  // namespace

double RandomRecords::between(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_);
}

double RandomRecords::log_between(double low, double high) {
  return std::exp(between(std::log(low), std::log(high)));
}

RandomRecord RandomRecords::next() {
  const double length = log_between(range_.shortest_length, range_.longest_length);
  const double longest = std::min(range_.longest_duration, 0.9 * length);
  const double d = log_between(std::min(range_.shortest_duration, 0.5 * longest), longest);
  const double rise = between(0.2, 0.8) * d;
  switch (n_++ % 9) {
    case 0:
      return {"triangle", length, d, [=](double t) { return triangle(t, 0., d, rise); }};
    case 1:
      return {"half sine", length, d, [=](double t) { return t < d ? std::sin(pi * t / d) : 0.; }};
    case 2: {
      const double plateau = between(0.2, 0.5), gone = std::min(length, d * between(1.5, 4.));
      return {"church roof", length, d, [=](double t) {
                if (t < rise) return t / rise;
                if (t < d) return 1. - (1. - plateau) * (t - rise) / (d - rise);
                return std::max(0., plateau * (gone - t) / (gone - d));
              }};
    }
    case 3: {
      const double second = between(0.5, 1.5) * d, start = between(0., std::max(0.01 * d, length - second)),
                   height = between(-1., 1.);
      const Pulses pulses{{0., d, rise, 1.}, {start, second, 0.5 * second, height}};
      return {"two pulses", length, d, [=](double t) { return sum(pulses, t); }};
    }
    case 4: {
      Pulses pulses;
      for (double t = 0.; t < length - d && pulses.size() < 200; t += d * between(1., 4.))
        pulses.push_back({t, d, rise, between(0.3, 1.)});
      return {"train", length, d, [=](double t) { return sum(pulses, t); }};
    }
    case 5: {
      const Swing swing{{{pi / d, 0., 1.}}, length};
      return {"swing", length, d, swing};
    }
    case 6: {
      Swing noise{{}, length};
      for (int i = 0; i < 20; ++i) {
        const double omega = log_between(std::min(0.5 * pi / d, pi / length), pi / d);
        noise.waves.push_back({omega, between(0., 2. * pi), between(0., 1.)});
      }
      return {"noise", length, d, noise};
    }
    case 7:
      return {"cut off", length, d, [=](double t) { return t < length ? 0.5 * std::min(1., t / d) : 0.; }, true};
    default: {
      const double slow = std::max(d, 0.9 * length - d);
      const Pulses pulses{{0., slow + d, slow, 1.}};
      return {"slow rise, fast fall", length, d, [=](double t) { return sum(pulses, t); }};
    }
  }
}

}  // namespace upbead::test
