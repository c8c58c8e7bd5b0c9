// Static equilibrium of soil with laws along a path of loads. A step that fails is cut; after that steps grow again.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fem/static_soil.h"

namespace upbead {

/// The loads, as functions of a parameter that grows.
struct StaticPath {
  std::function<Vector(double)> load;                ///< nodal forces
  std::vector<int> held;                             ///< unknowns that are prescribed
  std::function<std::vector<double>(double)> place;  ///< prescribed values of these; not called where none are held
  std::function<void()> each;                        ///< called in every iteration; may throw to end the march
};

struct StaticSteps {
  double from = 0., to = 1.;
  double first = 0.25;      ///< of the parameter
  double least = 1e-3;      ///< the march ends if a step of at most this length fails
  double largest = 1.;      ///< longest step
  double tolerance = 1e-6;  ///< |forces out of balance| over |forces|
  /// All flow is associated: then the forces are the gradient of a convex function, and Newton's method seeks its
  /// least value. It finds equilibrium even where |forces out of balance| must grow on the way.
  bool associated = false;
};

struct StaticReport {
  double reached = 0.;  ///< last parameter in equilibrium
  double failed = 0.;   ///< least parameter beyond it without equilibrium; StaticSteps::to if all is reached
  bool complete = false;
  Vector moved;  ///< in the last step; if it failed, as far as Newton's method came: where the ground fails
  int steps = 0, cuts = 0;
  int iterations = 0;    ///< each with one factorisation
  double residual = 0.;  ///< of the last equilibrium, relative
};

/// Called after each equilibrium; false ends the march.
using StaticObserver = std::function<bool(double parameter, const Vector& x, const Vector& soil_force)>;

/// Newton's method in every step, from an extrapolation of the last step. The soil is left in the last equilibrium,
/// as is x. Throws NumericsError where PETSc fails.
StaticReport march_static(StaticSoil& soil, const StaticPath& path, const StaticSteps& steps, Vector& x,
                          const StaticObserver& observer = {});

}  // namespace upbead
