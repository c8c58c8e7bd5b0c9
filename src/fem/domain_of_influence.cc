#include "fem/domain_of_influence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fem/sides.h"
#include "fem/volume_loads.h"

namespace upbead {

using namespace dealii;

namespace {

/// Sources of waves, or places of readings: surfaces, curves and points, each with its bounding box. A box is never
/// farther away than its contents, so that no cell is left out wrongly; and boxes are few, however many cells there
/// are.
class Boxes {
 public:
  void add(const std::string& name, const Point<dim>& point) {
    const auto [place, is_new] = boxes_.try_emplace(name, Box{point, point});
    if (is_new) return;
    for (int d = 0; d < dim; ++d) {
      place->second.least[d] = std::min(place->second.least[d], point[d]);
      place->second.most[d] = std::max(place->second.most[d], point[d]);
    }
  }
  bool empty() const { return boxes_.empty(); }
  /// Distance to the nearest box; 0 inside.
  double distance(const Point<dim>& from) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [name, box] : boxes_) {
      double square = 0.;
      for (int d = 0; d < dim; ++d) {
        const double outside = std::max({box.least[d] - from[d], from[d] - box.most[d], 0.});
        square += outside * outside;
      }
      nearest = std::min(nearest, std::sqrt(square));
    }
    return nearest;
  }

 private:
  struct Box {
    Point<dim> least, most;
  };
  std::map<std::string, Box> boxes_;
};

struct Ends {
  Boxes sources, readers;
};

bool is_loaded(const Scene& scene, const std::string& curve) {
  for (const auto& [name, load] : scene.loads)
    if (load.factor != 0. && !load.boundary.empty() && load.boundary == curve) return true;
  return false;
}

bool is_loaded_inside(const Scene& scene, const std::string& surface) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const auto& entry) {
    const Load& load = entry.second;
    return load.factor != 0. && is_on_volume(load.kind) && acts_on(load, surface);
  });
}

Ends ends_of(const Scene& scene, const Mesh& mesh) {
  Ends ends;
  for (const auto& [name, probe] : scene.probes)
    ends.readers.add("probe " + name, Point<dim>(probe.at[0], probe.at[1]));
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& surface = mesh.surface_of(cell);
    const bool rigid = scene.regions.at(surface).kind == RegionKind::rigid;
    const bool source = rigid || is_loaded_inside(scene, surface);  // a rigid body passes motion on at once
    for (const unsigned v : cell->vertex_indices()) {
      if (source) ends.sources.add("surface " + surface, cell->vertex(v));
      if (rigid || surface == caisson_name) ends.readers.add("surface " + surface, cell->vertex(v));
    }
    for (const auto& face : cell->face_iterators())
      if (const std::string& curve = mesh.curve_of(face); is_loaded(scene, curve))
        for (unsigned v = 0; v < 2; ++v) ends.sources.add("curve " + curve, face->vertex(v));
  }
  return ends;
}

}  // namespace

DomainOfInfluence domain_of_influence(const Scene& scene, const Mesh& mesh) {
  DomainOfInfluence domain;
  if (scene.mesh.full_domain || scene.fields_every || !scene.time.inertia) return domain;
  for (const auto& [name, region] : scene.regions)
    domain.speed = std::max(domain.speed, fastest_wave(region, scene.fluid, scene.gravity));
  if (std::isinf(domain.speed)) return domain;
  const Ends ends = ends_of(scene, mesh);
  if (ends.sources.empty() || ends.readers.empty()) return domain;
  domain.outside.assign(mesh.triangulation.n_active_cells(), false);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const Point<dim> middle = cell->center();
    const double way = ends.sources.distance(middle) + ends.readers.distance(middle) - cell->diameter();
    if (way <= domain.speed * scene.time.end) continue;
    domain.outside[cell->active_cell_index()] = true;
    ++domain.n_outside;
  }
  if (domain.n_outside == 0) domain.outside.clear();
  return domain;
}

}  // namespace upbead
