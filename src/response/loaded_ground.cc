#include "response/loaded_ground.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace upbead {

using Point = dealii::Point<dim>;
using Direction = dealii::Tensor<1, dim>;
using MeshCell = dealii::Triangulation<dim>::active_cell_iterator;

namespace {

constexpr double least_part = 0.1;   ///< of a load along a direction that counts
constexpr double plane_share = 0.9;  ///< of the mesh's width

bool deforms(const Region& region) {
  return region.kind == RegionKind::porous ||
         (region.kind == RegionKind::solid && region.deformation != Deformation::rigid);
}

struct Extent {
  double low = 1e300, high = -1e300;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double width() const { return high - low; }
};

Extent span(const MeshCell& cell, const Direction& along) {
  Extent span;
  for (const unsigned v : cell->vertex_indices()) span.add(cell->vertex(v) * along);
  return span;
}

/// Where a load acts on ground that deforms.
struct Side {
  std::vector<std::array<Point, 2>> faces;
  Direction normal;  ///< outward, mean, of length 1
  Direction along() const {
    Direction t;
    t[0] = -normal[1];
    t[1] = normal[0];
    return t;
  }
  double distance(const Point& point) const {
    double least = 1e300;
    for (const auto& [a, b] : faces) {
      const auto way = b - a;
      const double share = std::clamp(((point - a) * way) / way.norm_square(), 0., 1.);
      least = std::min(least, point.distance(a + share * way));
    }
    return least;
  }
};

Side side_of(const Load& load, const Scene& scene, const Mesh& mesh) {
  Side side;
  Direction sum;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (!deforms(scene.regions.at(mesh.surface_of(cell)))) continue;
    for (const auto& face : cell->face_iterators()) {
      if (mesh.curve_of(face) != load.boundary) continue;
      side.faces.push_back({face->vertex(0), face->vertex(1)});
      const auto way = face->vertex(1) - face->vertex(0);
      Direction normal;
      normal[0] = way[1];
      normal[1] = -way[0];
      sum += (normal * (face->center() - cell->center()) > 0. ? 1. : -1.) * normal;
    }
  }
  if (const double length = sum.norm(); length > 0.) side.normal = sum / length;
  return side;
}

/// Of a cell, along a direction: the root of its area times how it is stretched.
double size_along(const MeshCell& cell, const Direction& normal, const Direction& along) {
  return std::sqrt(cell->measure() * span(cell, normal).width() / span(cell, along).width());
}

struct Probed {
  std::string name;
  double distance;
};

/// Probes by region.
std::map<std::string, std::vector<Probed>> probes_by_region(const Scene& scene, const Mesh& mesh, const Side& side) {
  std::map<std::string, std::vector<Probed>> found;
  for (const auto& [name, probe] : scene.probes) {
    const Point at(probe.at[0], probe.at[1]);
    for (const auto& cell : mesh.triangulation.active_cell_iterators())
      if (deforms(scene.regions.at(mesh.surface_of(cell))) && cell->point_inside(at)) {
        found[mesh.surface_of(cell)].push_back({"probe '" + name + "'", side.distance(at)});
        break;
      }
  }
  return found;
}

void find_cells(const Mesh& mesh, const Side& side, bool whole, LoadedGround& ground) {
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (mesh.surface_of(cell) != ground.region) continue;
    if (!ground.is_plane && !whole && side.distance(cell->center()) > ground.farthest) continue;
    ground.cell = std::max(ground.cell, size_along(cell, side.normal, side.along()));
    if (whole) ground.farthest = std::max(ground.farthest, side.distance(cell->center()));
  }
}

void act(const Load& load, const Side& side, LoadedGround& ground) {
  const bool is_pressure = load.kind == LoadKind::pressure || load.kind == LoadKind::pressures;
  Direction direction;
  for (unsigned d = 0; d < dim; ++d) direction[d] = load.direction[d];
  const double length = direction.norm();
  ground.pushes = is_pressure || std::abs(direction * side.normal) > least_part * length;
  ground.shears = !is_pressure && std::abs(direction * side.along()) > least_part * length;
}

double width_across(const Mesh& mesh, const Direction& along) {
  Extent all;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned v : cell->vertex_indices()) all.add(cell->vertex(v) * along);
  return all.width();
}

bool is_plane(const Mesh& mesh, const Side& side) {
  Extent loaded;
  for (const auto& face : side.faces)
    for (const Point& end : face) loaded.add(end * side.along());
  return loaded.width() >= plane_share * width_across(mesh, side.along());
}

}  // namespace

std::vector<LoadedGround> loaded_grounds(const Scene& scene, const Mesh& mesh) {
  std::vector<LoadedGround> list;
  for (const auto& [name, load] : scene.loads) {
    if (load.factor == 0. || load.boundary.empty()) continue;
    const Side side = side_of(load, scene, mesh);
    if (side.faces.empty()) continue;
    auto seen = probes_by_region(scene, mesh, side);
    if (scene.fields_every)
      for (const auto& [region, what] : scene.regions)
        if (deforms(what)) seen[region].push_back({"the fields", 0.});
    for (const auto& [region, probes] : seen) {
      LoadedGround ground{name, region, "", false, false, is_plane(mesh, side), 0., 1e300, 0.};
      for (const Probed& probe : probes) {
        if (probe.distance < ground.nearest) ground.onlooker = probe.name;
        ground.nearest = std::min(ground.nearest, probe.distance);
        ground.farthest = std::max(ground.farthest, probe.distance);
      }
      act(load, side, ground);
      find_cells(mesh, side, scene.fields_every.has_value(), ground);
      if (ground.cell > 0.) list.push_back(ground);
    }
  }
  return list;
}

}  // namespace upbead
