// Loads: where they act, how they are spread, how they run in time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "upbead/base/time_function.h"

namespace upbead {

enum class PulseShape { triangle, step, half_sine, church_roof, harmonic };

/// An idealised history; zero before `start`. Which members a shape needs: check(pulse).
struct Pulse {
  PulseShape shape = PulseShape::triangle;
  double peak = 0.;                ///< largest value (N/m or Pa; amplitude of a harmonic)
  std::optional<double> rise;      ///< s; triangle, church_roof (default duration/2); step: a ramp (default 0)
  std::optional<double> duration;  ///< s; triangle, half_sine, church_roof (its impulsive part)
  double start = 0.;               ///< s
  std::optional<double> plateau;           ///< church_roof: slow part over peak
  std::optional<double> plateau_duration;  ///< church_roof: s, from start until the slow part has gone
  std::optional<double> frequency;         ///< harmonic: Hz
};

std::vector<std::pair<std::string, std::string>> objections(const Pulse& pulse);  ///< (key, what is wrong)
TimeFunction time_function(const Pulse& pulse);

enum class LoadKind {
  force,     ///< resultant (N/m) in `direction`
  traction,  ///< Pa in `direction`
  pressure,  ///< Pa: total normal stress = -value, and pore pressure = value where the boundary is open
};

/// One table [loads.NAME].
struct Load {
  std::string boundary;                        ///< curve that it acts on, or
  std::string region;                          ///< a rigid region, with
  std::array<double, 2> at{0., 0.};            ///< the point of attack (m)
  LoadKind kind = LoadKind::force;
  std::array<double, 2> direction{1., 0.};
  std::vector<std::array<double, 2>> shape;    ///< (height y, relative intensity), linear between; empty: uniform
  TimeFunction history;
};

/// Relative intensity at height y: linear between the pairs of `shape`, constant beyond its ends, 1 where it is empty.
double intensity(const Load& load, double y);

}  // namespace upbead
