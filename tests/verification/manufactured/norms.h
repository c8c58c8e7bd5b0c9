// Errors of a computed state, and how they fall with the size of the cells.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "meshes.h"
#include "sources.h"

namespace upbead::test {

/// Errors over the rectangle, each over the same norm of the exact field: "u in L2", "u in H1" (its gradient), "phi in
/// L2", "p in L2"; with inertial flow "W in L2".
std::map<std::string, double> errors(const Problem& problem, const State& state);

/// Errors on a sequence of meshes.
struct Refinement {
  std::vector<double> h;                             ///< side of the squares (m)
  std::map<std::string, std::vector<double>> error;  ///< by norm

  /// Least-squares slope over the three finest meshes.
  double order_of(const std::string& norm) const;
};

/// Solves on meshes of cells h, from the largest to the smallest, each by `steps` steps of sdirk4 up to `end` (s).
Refinement refinement(const Manufactured& mms, Quads quads, const std::vector<double>& h, double end, int steps);

}  // namespace upbead::test
