// A manufactured solution: fields chosen first, and the sources under which they solve the equations.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "closed_forms.h"
#include "scenes.h"

namespace upbead::test {

/// One solution with one set of parameters on the rectangle `lower` to `upper`. Its scene has only regions, the
/// surfaces "lower layer" and "upper layer" of a mesh, which meet at y = interface, and free and sealed sides: all
/// that acts on the sides comes from the closed forms.
struct Manufactured {
  Json entry;        ///< expressions, sets
  std::string kind;  ///< "trig", "two-layer", "time-only", "patch", "inertial"
  Scene scene;
  dealii::Point<dim> lower, upper;                             ///< m
  double interface = 0.;                                       ///< m; the lower side where there is one layer
  double end = 0.;                                             ///< t_end of the reference (s)
  std::map<std::string, std::shared_ptr<ClosedForms>> layers;  ///< by surface
  /// Every closed form is a sum of (function of x, y) times one of these.
  std::vector<std::function<double(double)>> time_functions;

  /// "lower layer" or "upper layer".
  const std::string& surface_at(const dealii::Point<dim>& at) const;
};

/// Solution `kind` of tests/reference/FILE.json with its set number `set`, for elements of that degree.
Manufactured manufactured(const std::string& file, const std::string& kind, std::size_t set, int degree);

}  // namespace upbead::test
