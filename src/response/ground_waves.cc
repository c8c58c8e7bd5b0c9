#include "response/ground_waves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/numbers.h"
#include "fem/outline.h"

namespace upbead {

namespace {

using MeshPoint = dealii::Point<dim>;
using Direction = dealii::Tensor<1, dim>;
using MeshCell = dealii::Triangulation<dim>::active_cell_iterator;

struct Extent {
  double low = infinity, high = -infinity;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const MeshCell& cell, const Direction& along) {
    for (const unsigned v : cell->vertex_indices()) add(cell->vertex(v) * along);
  }
  double width() const { return high - low; }
};

Extent span(const MeshCell& cell, const Direction& along) {
  Extent span;
  span.add(cell, along);
  return span;
}

Direction direction(double x, double y) {
  Direction along;
  along[0] = x;
  along[1] = y;
  return along;
}

/// Distance from the caisson's bottom (m).
double distance(const dealii::Point<dim>& point, const Caisson& caisson) {
  const double beside = std::max(std::abs(point[0] - caisson.bottom_centre[0]) - 0.5 * caisson.bottom_width, 0.);
  return std::hypot(beside, point[1] - caisson.bottom_centre[1]);
}

constexpr double thin = 0.25, soft = 5.;

/// Sums over a region, from one pass through the mesh.
struct Seen {
  double area = 0., modulus = 0.;  ///< of the whole region; modulus times area
  double area_near = 0., longest = 0.;
  Extent near;
};

/// Speed of shear waves (m/s), mean over the area of the surfaces; 0 where all of them are water.
double mean_shear_speed(const Space& space, const std::set<std::string>& surfaces) {
  double sum = 0., area = 0.;
  for (const auto& cell : space.mesh().triangulation.active_cell_iterators()) {
    if (surfaces.count(space.mesh().surface_of(cell)) == 0) continue;
    const double speed = shear_speed(space, cell);
    if (speed == 0.) continue;
    sum += speed * area_of(cell);
    area += area_of(cell);
  }
  return area > 0. ? sum / area : 0.;
}

/// Whether the ground is saturated: with undrained sand the dashpots rho V_p are too stiff for the waves that arrive:
/// docs/sides.md.
bool is_saturated(const Scene& scene, const std::set<std::string>& surfaces) {
  return std::any_of(surfaces.begin(), surfaces.end(), [&](const std::string& name) {
    const Region& region = scene.regions.at(name);
    return region.kind == RegionKind::porous && region.flow != Flow::drained;
  });
}

constexpr double least_part = 0.1;   ///< smallest share of a load along a direction that counts
constexpr double plane_share = 0.9;  ///< share of the mesh's width

bool deforms(const Region& region) {
  return region.kind == RegionKind::porous ||
         (region.kind == RegionKind::solid && region.deformation != Deformation::rigid);
}

/// The side on which a load acts on ground that deforms.
struct Side {
  std::vector<std::array<MeshPoint, 2>> faces;
  Direction normal;  ///< outward, mean, of length 1
  Direction along() const { return direction(-normal[1], normal[0]); }
  double distance(const MeshPoint& point) const {
    double least = 1e300;
    for (const auto& [a, b] : faces) least = std::min(least, distance_to_line(point, a, b));
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
      const Direction normal = direction(way[1], -way[0]);
      sum += (normal * (face->center() - cell->center()) > 0. ? 1. : -1.) * normal;
    }
  }
  if (const double length = sum.norm(); length > 0.) side.normal = sum / length;
  return side;
}

/// Size of a cell along a direction: the root of its area, times how much it is stretched that way.
double size_along(const MeshCell& cell, const Direction& normal, const Direction& along) {
  return std::sqrt(area_of(cell) * span(cell, normal).width() / span(cell, along).width());
}

struct Probed {
  std::string name;
  double distance;
};

/// Probes by region.
std::map<std::string, std::vector<Probed>> probes_by_region(const Scene& scene, const Mesh& mesh, const Side& side) {
  std::map<std::string, std::vector<Probed>> found;
  for (const auto& [name, probe] : scene.probes) {
    const MeshPoint at(probe.at[0], probe.at[1]);
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
  // these press along the normal, whatever their unused direction says
  const bool presses =
      load.kind == LoadKind::pressure || load.kind == LoadKind::pressures || load.kind == LoadKind::normal;
  const Direction way = direction(load.direction[0], load.direction[1]);
  ground.pushes = presses || std::abs(way * side.normal) > least_part * way.norm();
  ground.shears = !presses && std::abs(way * side.along()) > least_part * way.norm();
}

bool is_plane(const Mesh& mesh, const Side& side) {
  Extent loaded, all;
  for (const auto& face : side.faces)
    for (const MeshPoint& end : face) loaded.add(end * side.along());
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) all.add(cell, side.along());
  return loaded.width() >= plane_share * all.width();
}

}  // namespace

double distance_to_line(const MeshPoint& point, const MeshPoint& a, const MeshPoint& b) {
  const auto way = b - a;
  return point.distance(a + std::clamp(((point - a) * way) / way.norm_square(), 0., 1.) * way);
}

double shear_speed(const Space& space, const Space::MeshCell& cell) {
  const Material& m = space.material(cell);
  return m.G > 0. ? std::sqrt(m.G / m.rho) : 0.;
}

std::vector<WaveResolution> wave_resolution(const Space& space, const Caisson& caisson, double duration) {
  const Mesh& mesh = space.mesh();
  std::map<std::string, WaveResolution> found;
  std::map<std::string, double> area;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& name = mesh.surface_of(cell);
    const double speed = shear_speed(space, cell);
    if (name == caisson_name || speed == 0.) continue;
    found[name].speed += speed * area_of(cell);
    area[name] += area_of(cell);
  }
  for (auto& [name, at] : found) {
    at.region = name;
    at.speed /= area[name];
    at.wavelength = at.speed * duration + caisson.bottom_width;
  }
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (const auto at = found.find(mesh.surface_of(cell)); at != found.end())
      if (distance(cell->center(), caisson) <= at->second.wavelength)
        at->second.cell = std::max(at->second.cell, std::sqrt(area_of(cell)));
  std::vector<WaveResolution> list;
  for (const auto& [name, at] : found)
    if (at.cell > 0.) list.push_back(at);
  return list;
}

std::vector<ThinLayer> thin_layers(const Space& space, const Caisson& caisson) {
  const Mesh& mesh = space.mesh();
  std::map<std::string, Seen> regions;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& name = mesh.surface_of(cell);
    const double G = space.material(cell).G;
    if (name == caisson_name || G == 0.) continue;
    Seen& seen = regions[name];
    seen.area += area_of(cell);
    seen.modulus += area_of(cell) * G;
    if (std::abs(cell->center()[0] - caisson.bottom_centre[0]) > caisson.bottom_width) continue;
    seen.longest = std::max(seen.longest, span(cell, direction(1., 0.)).width());
    seen.near.add(cell, direction(1., 0.));
    seen.area_near += area_of(cell);
  }
  double stiffest = 0.;
  for (const auto& [name, seen] : regions) stiffest = std::max(stiffest, seen.modulus / seen.area);
  std::vector<ThinLayer> list;
  for (const auto& [name, seen] : regions) {
    if (seen.area_near == 0.) continue;
    const ThinLayer layer{name, seen.area_near / seen.near.width(), seen.longest,
                          regions.size() == 1 ? infinity : stiffest * seen.area / seen.modulus};
    if (layer.thickness < thin * caisson.bottom_width && layer.contrast >= soft) list.push_back(layer);
  }
  return list;
}

std::optional<BoundaryReflection> first_reflection(const Scene& scene, const Space& space) {
  const Mesh& mesh = space.mesh();
  const auto sides = far_sides(mesh);
  std::set<std::string> grounds;
  for (const auto& [side, surfaces] : sides) grounds.insert(surfaces.begin(), surfaces.end());
  std::map<std::string, Extent> of_side;
  Extent middle;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (grounds.count(mesh.surface_of(cell)) == 0) middle.add(cell, direction(1., 0.));
    for (const auto& face : cell->face_iterators())
      if (face->at_boundary()) of_side[mesh.curve_of(face)].add(face->center()[0]);
  }
  std::optional<BoundaryReflection> first;
  if (scene.regions.count(caisson_name) == 0 || middle.low > middle.high) return first;
  for (const auto& [side, surfaces] : sides) {
    const double x = of_side.at(side).low;
    BoundaryReflection reflection{side, std::max(middle.low - x, x - middle.high), mean_shear_speed(space, surfaces),
                                  false};
    reflection.absorbing = scene.boundaries.at(side).displacement == DisplacementCondition::absorbing;
    if (reflection.speed == 0. || reflection.distance <= 0. || (reflection.absorbing && !is_saturated(scene, surfaces)))
      continue;
    if (!first || reflection.time() < first->time()) first = reflection;
  }
  return first;
}

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
