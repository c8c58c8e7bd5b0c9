// A prescribed uplift: its course in time, and its pressure on the base.
#pragma once

#include <array>
#include <vector>

#include "fem/compile.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// U(t) (N/m) in a run until `end` (s); P(t) is the horizontal force on the caisson. Needs a prescribed uplift.
TimeFunction prescribed_uplift(const UpliftChoice& uplift, const TimeFunction& P, double end);

/// A part of p_u(x, t): its values for f(t) = 1, and f(t).
struct UpliftLoad {
  Vector node;            ///< force of each node of the base, upward on the caisson (N/m)
  double force = 0.;      ///< their sum (N/m)
  double moment = 0.;     ///< about the middle of the base, overturning landward positive (N m/m)
  TimeFunction pressure;  ///< f
};

/// p_u(x, t) of the scene's prescribed uplift on the nodes of the base at `position` (m), each for a `length` of the
/// base (m); none without a prescribed uplift or a caisson. Where it is given by a peak or history, `distribution`
/// says how it is spread, and f is U(t).
std::vector<UpliftLoad> uplift_loads(const Simulation& simulation, const std::vector<double>& position,
                                     const std::vector<double>& length);

/// p(t) of the loads on the caisson's walls at their feet, seaward and landward (Pa): that of the water there, but for
/// a sea that is meshed.
std::array<TimeFunction, 2> pressures_at_feet(const Simulation& simulation);

}  // namespace upbead
