// Checks of what a case says of rigid bodies: their parts, and water beside the caisson's walls.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/checker.h"

namespace upbead {

using namespace dealii;

namespace {

using Corners = std::vector<Point<dim>>;

/// What of a convex polygon lies above (sign 1) or below (-1) the value of a coordinate (Sutherland and Hodgman 1974).
Corners cut(const Corners& polygon, unsigned coordinate, double value, double sign) {
  Corners left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<dim>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = sign * (a[coordinate] - value), to = sign * (b[coordinate] - value);
    if (from >= 0.) left.push_back(a);
    if ((from < 0. && to > 0.) || (from > 0. && to < 0.)) left.push_back(a + (b - a) * (from / (from - to)));
  }
  return left;
}

/// The area that a cell and a part have in common (m2).
double common_area(const Triangulation<dim>::active_cell_iterator& cell, const BodyPart& part) {
  Corners polygon{cell->vertex(0), cell->vertex(1), cell->vertex(3), cell->vertex(2)};
  for (const auto& [coordinate, sides] : {std::pair{0U, part.x}, {1U, part.y}})
    polygon = cut(cut(polygon, coordinate, sides[0], 1.), coordinate, sides[1], -1.);
  double twice = 0.;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Tensor<1, dim> a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * std::abs(twice);
}

void check_part(Checker& checker, const std::string& region, const std::string& name, const BodyPart& part) {
  constexpr double same = 1e-6;
  double inside = 0.;
  for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
    if (checker.mesh.surface_of(cell) == region) inside += common_area(cell, part);
  if (inside >= (1. - same) * part.area()) return;
  checker.object("regions." + region + ".parts." + name,
                 (inside > 0. ? significant(100. * (1. - inside / part.area()), 3) + " % of it lies" : "it lies") +
                     " outside of '" + region + "' as meshed",
                 "give the sides x and y of a part of the meshed body; a parapet is meshed by parapet_width and "
                 "parapet_height of the shipped geometries");
}

/// One side of the caisson: the height of the water beside it that is not meshed.
struct WallSide {
  const char* key;
  double height = 0.;
  bool seaward = false;
};

}  // namespace

/// Parts of a rigid body lie in it.
void check_body_parts(Checker& checker) {
  for (const auto& [region, values] : checker.scene.regions)
    if (checker.outline.surfaces.count(region))
      for (const auto& [name, part] : values.parts) check_part(checker, region, name, part);
}

/// Water beside the caisson's walls as a mass, on a side where no sea is meshed.
void check_added_mass(Checker& checker) {
  for (const auto& [name, region] : checker.scene.regions)
    if (region.added_mass && name != caisson_name)
      checker.object("regions." + name + ".added_mass", "only the caisson has walls in the sea", "remove it");
  const auto caisson = checker.scene.regions.find(caisson_name);
  const auto bounds = checker.outline.surfaces.find(caisson_name);
  if (caisson == checker.scene.regions.end() || !caisson->second.added_mass) return;
  const std::string key = "regions.caisson.added_mass";
  if (!checker.scene.time.inertia)
    checker.object(key, "without inertia (time.inertia = false) no mass counts", "remove it");
  if (bounds == checker.outline.surfaces.end()) return;
  const WallWater& water = *caisson->second.added_mass;
  const double middle = 0.5 * (bounds->second.left + bounds->second.right);
  const auto is_seaward = [&](const Bounds& other) { return 0.5 * (other.left + other.right) < middle; };
  for (const auto& [side, height, seaward] : {WallSide{"seaward", water.seaward, true}, {"landward", water.landward}}) {
    if (!(height > 0.)) continue;
    for (const std::string& surface : checker.outline.touching(caisson_name))
      if (checker.is(surface, RegionKind::water) && is_seaward(checker.outline.surfaces.at(surface)) == seaward)
        checker.object(key + "." + side,
                       "the water of '" + surface + "' on that side is meshed: its mass would count twice",
                       std::string("write ") + side + " = 0, or take a mesh without that sea");
    for (const auto& [name, load] : checker.scene.loads)
      if (const auto curve = checker.outline.outer.find(load.boundary);
          load.measured_on_wall && load.factor != 0. &&
          (curve == checker.outline.outer.end() || is_seaward(curve->second.bounds) == seaward))
        checker.object(
            "loads." + name + ".measured_on_wall",
            "a force measured on the moving wall holds the push of its water, which added_mass would add again",
            std::string("write ") + side + " = 0 of added_mass, or leave out measured_on_wall");
  }
  const double height = bounds->second.highest - bounds->second.lowest;
  if (std::max(water.seaward, water.landward) > height * (1. + 1e-9))
    checker.object(key, "the water is higher than the caisson's walls, " + significant(height) + " m",
                   "give its height above the caisson's base, at most that of the walls");
}

}  // namespace upbead
