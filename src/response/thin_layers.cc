#include "response/thin_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace upbead {

namespace {

constexpr double thin = 0.25, soft = 5.;

/// What is seen of a region on the way through the mesh.
struct Seen {
  double area = 0., modulus = 0.;  ///< of all of it; modulus times area
  double area_near = 0., left = 0., right = 0., longest = 0.;
};

double x_extent(const dealii::Triangulation<dim>::active_cell_iterator& cell, double& left, double& right) {
  left = std::numeric_limits<double>::infinity();
  right = -left;
  for (const unsigned v : cell->vertex_indices()) {
    left = std::min(left, cell->vertex(v)[0]);
    right = std::max(right, cell->vertex(v)[0]);
  }
  return right - left;
}

}  // namespace

std::vector<ThinLayer> thin_layers(const Space& space, const Caisson& caisson) {
  const Mesh& mesh = space.mesh();
  std::map<std::string, Seen> regions;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& name = mesh.surface_of(cell);
    const double G = space.material(cell).G;
    if (name == caisson_name || G == 0.) continue;
    Seen& seen = regions[name];
    seen.area += cell->measure();
    seen.modulus += cell->measure() * G;
    if (std::abs(cell->center()[0] - caisson.bottom_centre[0]) > caisson.bottom_width) continue;
    double left = 0., right = 0.;
    seen.longest = std::max(seen.longest, x_extent(cell, left, right));
    seen.left = seen.area_near == 0. ? left : std::min(seen.left, left);
    seen.right = seen.area_near == 0. ? right : std::max(seen.right, right);
    seen.area_near += cell->measure();
  }
  double stiffest = 0.;
  for (const auto& [name, seen] : regions) stiffest = std::max(stiffest, seen.modulus / seen.area);
  std::vector<ThinLayer> list;
  for (const auto& [name, seen] : regions) {
    if (seen.area_near == 0.) continue;
    const ThinLayer layer{
        name, seen.area_near / (seen.right - seen.left), seen.longest,
        regions.size() == 1 ? std::numeric_limits<double>::infinity() : stiffest * seen.area / seen.modulus};
    if (layer.thickness < thin * caisson.bottom_width && layer.contrast >= soft) list.push_back(layer);
  }
  return list;
}

}  // namespace upbead
