// The layout of a mesh: its surfaces and curves, which of them meet, and in which cell a point lies.
#pragma once

#include <deal.II/base/point.h>

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "upbead/mesh/mesh.h"

namespace upbead {

using Names = std::set<std::string>;

/// Extent of a surface or a curve (m).
struct Bounds {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  double lowest = left, highest = -left;
  void add(const dealii::Point<dim>& point);
};

struct OuterCurve {
  Bounds bounds;
  Names surfaces;  ///< surfaces behind the curve
};

struct Outline {
  std::map<std::string, Bounds> surfaces;
  std::map<std::string, OuterCurve> outer;                                     ///< outer parts of curves, by name
  std::map<std::string, std::set<std::pair<std::string, std::string>>> inner;  ///< surfaces on both sides of a curve
  std::set<std::pair<std::string, std::string>> contacts;  ///< surfaces that share a face, in alphabetical order
  Names beside_caisson;                                    ///< surfaces that the caisson touches, except at its bottom

  /// All surfaces that share a face with this one.
  Names touching(const std::string& surface) const;
};

Outline outline_of(const Mesh& mesh);

/// Names of the outer curves that are vertical lines and do not belong to the caisson, and of the surfaces behind
/// them.
std::map<std::string, std::set<std::string>> far_sides(const Mesh& mesh);

/// Coordinates of a point in the unit cell; none where it lies outside the cell. A point on the cell's boundary is
/// inside.
std::optional<dealii::Point<dim>> unit_coordinates(const dealii::Triangulation<dim>::active_cell_iterator& cell,
                                                   const dealii::Point<dim>& point);

}  // namespace upbead
