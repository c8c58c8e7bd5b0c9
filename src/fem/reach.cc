#include "reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "upbead/fem/wave_sides.h"

namespace upbead {

using namespace dealii;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Points = std::vector<Point<dim>>;

/// Points that waves start from and points where they are read.
struct Ends {
  Points sources, readers;
};

bool is_loaded(const Scene& scene, const std::string& curve) {
  for (const auto& [name, load] : scene.loads)
    if (load.factor != 0. && !load.boundary.empty() && load.boundary == curve) return true;
  return false;
}

Ends ends_of(const Scene& scene, const Mesh& mesh) {
  Ends ends;
  for (const auto& [name, probe] : scene.probes) ends.readers.emplace_back(probe.at[0], probe.at[1]);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& surface = mesh.surface_of(cell);
    const bool rigid = scene.regions.at(surface).kind == RegionKind::rigid;
    for (const unsigned v : cell->vertex_indices()) {
      if (rigid) ends.sources.push_back(cell->vertex(v));  // it hands motion on at once
      if (rigid || surface == caisson_name) ends.readers.push_back(cell->vertex(v));
    }
    for (const auto& face : cell->face_iterators())
      if (is_loaded(scene, mesh.curve_of(face)))
        for (unsigned v = 0; v < 2; ++v) ends.sources.push_back(face->vertex(v));
  }
  return ends;
}

double distance(const Point<dim>& from, const Points& to) {
  double least = infinity;
  for (const Point<dim>& point : to) least = std::min(least, from.distance_square(point));
  return std::sqrt(least);
}

}  // namespace

Reach find_reach(const Scene& scene, const Mesh& mesh) {
  Reach reach;
  if (scene.mesh.keep_unreached || scene.fields_every || !scene.time.inertia) return reach;
  for (const auto& [name, region] : scene.regions)
    reach.speed = std::max(reach.speed, fastest_wave(region, scene.fluid, scene.gravity));
  if (std::isinf(reach.speed)) return reach;
  const Ends ends = ends_of(scene, mesh);
  if (ends.sources.empty() || ends.readers.empty()) return reach;
  reach.unreached.assign(mesh.triangulation.n_active_cells(), false);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const Point<dim> middle = cell->center();
    const double way = distance(middle, ends.sources) + distance(middle, ends.readers) - cell->diameter();
    if (way <= reach.speed * scene.time.end) continue;
    reach.unreached[cell->active_cell_index()] = true;
    ++reach.n_unreached;
  }
  if (reach.n_unreached == 0) reach.unreached.clear();
  return reach;
}

}  // namespace upbead
