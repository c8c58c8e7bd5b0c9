#include "response/far_echo.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/far_sides.h"
#include "response/wave_resolution.h"

namespace upbead {

namespace {

/// From left to right (m).
struct Span {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  void add(double x) {
    left = std::min(left, x);
    right = std::max(right, x);
  }
};

/// Of shear waves (m/s), mean over the area of the surfaces; 0 where there is water alone.
double mean_shear_speed(const Space& space, const std::set<std::string>& surfaces) {
  double sum = 0., area = 0.;
  for (const auto& cell : space.mesh().triangulation.active_cell_iterators()) {
    if (surfaces.count(space.mesh().surface_of(cell)) == 0) continue;
    const double speed = shear_speed(space, cell);
    if (speed == 0.) continue;
    sum += speed * cell->measure();
    area += cell->measure();
  }
  return area > 0. ? sum / area : 0.;
}

/// Undrained sand has rho V_p too stiff for the waves that arrive: docs/sides.md.
bool is_saturated(const Scene& scene, const std::set<std::string>& surfaces) {
  return std::any_of(surfaces.begin(), surfaces.end(), [&](const std::string& name) {
    const Region& region = scene.regions.at(name);
    return region.kind == RegionKind::porous && region.flow != Flow::drained;
  });
}

}  // namespace

std::optional<FarEcho> first_echo(const Scene& scene, const Space& space) {
  const Mesh& mesh = space.mesh();
  const auto sides = far_sides(mesh);
  std::set<std::string> grounds;
  for (const auto& [side, surfaces] : sides) grounds.insert(surfaces.begin(), surfaces.end());
  std::map<std::string, Span> of_side;
  Span middle;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (grounds.count(mesh.surface_of(cell)) == 0)
      for (const unsigned v : cell->vertex_indices()) middle.add(cell->vertex(v)[0]);
    for (const auto& face : cell->face_iterators())
      if (face->at_boundary()) of_side[mesh.curve_of(face)].add(face->center()[0]);
  }
  std::optional<FarEcho> first;
  if (scene.regions.count(caisson_name) == 0 || middle.left > middle.right) return first;
  for (const auto& [side, surfaces] : sides) {
    const double x = of_side.at(side).left;
    FarEcho echo{side, std::max(middle.left - x, x - middle.right), mean_shear_speed(space, surfaces), false};
    echo.absorbing = scene.boundaries.at(side).displacement == DisplacementCondition::absorbing;
    if (echo.speed == 0. || echo.distance <= 0. || (echo.absorbing && !is_saturated(scene, surfaces))) continue;
    if (!first || echo.time() < first->time()) first = echo;
  }
  return first;
}

}  // namespace upbead
