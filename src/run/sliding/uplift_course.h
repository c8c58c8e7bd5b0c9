// A prescribed uplift: its course in time.
#pragma once

#include "upbead/algebra/sparse.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Whether waves press on the landward wall alone: then all is as in a mirror.
bool pushes_seaward_alone(const TimeFunction& P, double end);

/// U(t) (N/m) in a run until `end` (s); P(t) is the horizontal force on the caisson. Needs a prescribed uplift.
TimeFunction prescribed_uplift(const UpliftChoice& uplift, const TimeFunction& P, double end);

/// A part of p_u(x, t): its values for f(t) = 1, and f(t).
struct UpliftLoad {
  Vector node;            ///< force of each node of the base, upward on the caisson (N/m)
  double force = 0.;      ///< their sum (N/m)
  double moment = 0.;     ///< about the middle of the base, overturning landward positive (N m/m)
  TimeFunction pressure;  ///< f
};

}  // namespace upbead
