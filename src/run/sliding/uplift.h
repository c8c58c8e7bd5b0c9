// A prescribed uplift: its course in time, and how it presses on the base.
#pragma once

#include <vector>

#include "fem/compile.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// U(t) (N/m) in a run until `end` (s); P(t) is the horizontal force on the caisson. Needs a prescribed uplift.
TimeFunction prescribed_uplift(const UpliftChoice& uplift, const TimeFunction& P, double end);

/// A part of p_u(x, t), f(t) per unit.
struct UpliftLoad {
  Vector node;            ///< force of each node of the base, upward on the caisson (N/m)
  double force = 0.;      ///< their sum (N/m)
  double moment = 0.;     ///< about the middle of the base, overturning landward positive (N m/m)
  TimeFunction pressure;  ///< f
};

/// p_u(x, t) of the scene's prescribed uplift on the nodes of the base at `position` (m), which stand for `length` each
/// (m); none without one, or without a caisson. By peak or history it is spread as `distribution` says, and f is U(t).
std::vector<UpliftLoad> uplift_loads(const Simulation& simulation, const std::vector<double>& position,
                                     const std::vector<double>& length);

}  // namespace upbead
