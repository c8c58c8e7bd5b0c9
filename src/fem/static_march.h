// Static equilibrium of soil with laws along a path of loads, in steps that are cut where one fails and grow again.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fem/static_soil.h"

namespace upbead {

/// What acts, by a parameter that grows.
struct StaticPath {
  std::function<Vector(double)> load;                ///< nodal forces
  std::vector<int> held;                             ///< unknowns that are prescribed
  std::function<std::vector<double>(double)> place;  ///< of these; not called where none are held
  std::function<StaticLaws(double)> laws;            ///< strengths by the parameter; none: they stay
};

struct StaticSteps {
  double from = 0., to = 1.;
  double first = 0.25;      ///< of the parameter
  double least = 1e-3;      ///< a step that fails and is not longer ends the march
  double largest = 1.;      ///< no step is longer
  double tolerance = 1e-6;  ///< |forces out of balance| over |forces|
  /// All flow is associated, so that forces are the slope of a convex function: Newton's method goes where this is
  /// least, and finds equilibrium where |forces out of balance| must grow on the way to it.
  bool associated = false;
};

struct StaticReport {
  double reached = 0.;  ///< last parameter in equilibrium
  double failed = 0.;   ///< least parameter beyond it at which none was found; where all is reached, that
  bool complete = false;
  Vector moved;  ///< in the last step; of one that failed as far as Newton's method came: where the ground gives way
  int steps = 0, cuts = 0;
  int iterations = 0;    ///< each with one factorisation
  double residual = 0.;  ///< of the last equilibrium, relative
};

/// Called after each equilibrium; false ends the march.
using StaticObserver = std::function<bool(double parameter, const Vector& x, const Vector& soil_force)>;

/// Newton's method in every step, begun from where the last step points. The soil is left in the last equilibrium, x
/// with it. Throws NumericsError where PETSc fails.
StaticReport march_static(StaticSoil& soil, const StaticPath& path, const StaticSteps& steps, Vector& x,
                          const StaticObserver& observer = {});

}  // namespace upbead
