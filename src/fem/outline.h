// The shape of a mesh in the large: its surfaces and curves, and what meets where.
#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "upbead/mesh/mesh.h"

namespace upbead {

using Names = std::set<std::string>;

/// Extent of a surface or a curve (m).
struct Extent {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  double lowest = left, highest = -left;
  void add(const dealii::Point<dim>& point);
};

struct OuterCurve {
  Extent extent;
  Names surfaces;  ///< behind it
};

struct Outline {
  std::map<std::string, Extent> surfaces;
  std::map<std::string, OuterCurve> outer;                                     ///< outer parts of curves, by name
  std::map<std::string, std::set<std::pair<std::string, std::string>>> inner;  ///< surfaces on both sides of a curve
  std::set<std::pair<std::string, std::string>> contacts;  ///< surfaces that share a face, in alphabetical order
  Names beside_caisson;  ///< surfaces that the caisson touches elsewhere than at its bottom

  /// All surfaces that share a face with this one.
  Names touching(const std::string& surface) const;
};

Outline outline_of(const Mesh& mesh);

}  // namespace upbead
