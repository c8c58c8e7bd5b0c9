#include "response/drainage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace upbead {

namespace {

constexpr double least_contrast = 10.;  ///< of the conductivities on both sides of a face

bool has_pore_pressure(const Region& region) {
  return region.kind == RegionKind::porous && region.flow != Flow::drained;
}

/// k of a region through a face whose normal has the vertical part n_y (m/s).
double through(const Region& region, double n_y) {
  return *region.hydraulic_conductivity * (1. + (region.conductivity_ratio - 1.) * n_y * n_y);
}

bool drains(const Region& soil, const Region& other, double n_y) {
  if (!has_pore_pressure(soil)) return false;
  if (other.kind == RegionKind::water) return true;
  return has_pore_pressure(other) && through(other, n_y) >= least_contrast * through(soil, n_y);
}

double consolidation(const Scene& scene, const Region& region, double n_y) {
  const Material m = material(region, scene.fluid, scene.gravity);
  return m.flow_along(n_y) / m.b / (m.alpha * m.alpha / m.constrained_modulus() + m.storage);
}

/// Pairs of c_v t / h^2 and the overshoot after that time.
using Table = std::array<std::array<double, 2>, 7>;
constexpr Table of_degree_1{
    {{1e-3, 0.257}, {0.01, 0.240}, {0.025, 0.202}, {0.05, 0.145}, {0.1, 0.048}, {1. / 6., 0.036}, {2., 0.}}};
constexpr Table of_degree_2{
    {{1e-3, 0.134}, {0.01, 0.069}, {0.025, 0.007}, {0.05, 0.007}, {0.1, 0.002}, {1. / 6., 0.001}, {2., 0.}}};

/// Interpolates linearly over the logarithm; constant beyond the ends.
double between(const Table& table, double ratio) {
  if (ratio <= table.front()[0]) return table.front()[1];
  for (std::size_t i = 0; i + 1 < table.size(); ++i) {
    const auto& [low, at_low] = table[i];
    const auto& [high, at_high] = table[i + 1];
    if (ratio <= high) return at_low + (at_high - at_low) * std::log(ratio / low) / std::log(high / low);
  }
  return table.back()[1];
}

bool is_under(const dealii::Point<dim>& point, const Caisson& caisson) {
  return std::abs(point[0] - caisson.bottom_centre[0]) < 0.5 * caisson.bottom_width &&
         point[1] < caisson.bottom_centre[1] && point[1] > caisson.bottom_centre[1] - caisson.bottom_width;
}

/// A region under the caisson, down to a depth of the caisson's width.
struct Layer {
  double area = 0.;                 ///< m2
  double G = 0., constrained = 0.;  ///< each times the area (Pa m2)
};

std::map<std::string, Layer> layers_under(const Space& space, const Caisson& caisson) {
  std::map<std::string, Layer> layers;
  for (const auto& cell : space.mesh().triangulation.active_cell_iterators()) {
    const std::string& name = space.mesh().surface_of(cell);
    const ElasticLaw& law = space.material(cell);
    if (name == caisson_name || law.G == 0. || !is_under(cell->center(), caisson)) continue;
    Layer& layer = layers[name];
    layer.area += area_of(cell);
    layer.G += law.G * area_of(cell);
    layer.constrained += law.constrained_modulus() * area_of(cell);
  }
  return layers;
}

/// Where water leaves the regions that drain.
struct Faces {
  std::string into;
  double length = 0., cell = 0.;  ///< m; the cell's size times the length
};

std::map<std::string, Faces> faces_under(const Scene& scene, const Mesh& mesh, const Caisson& caisson) {
  std::map<std::string, Faces> found;
  for (const DrainedFace& face : drained_faces(scene, mesh)) {
    if (!is_under(face.first + 0.5 * (face.last - face.first), caisson)) continue;
    const double length = face.first.distance(face.last);
    Faces& faces = found[face.region];
    faces.into = face.into;
    faces.length += length;
    faces.cell += face.cell * length;
  }
  return found;
}

}  // namespace

std::vector<DrainedFace> drained_faces(const Scene& scene, const Mesh& mesh) {
  std::vector<DrainedFace> list;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f)) continue;
      const std::string &name = mesh.surface_of(cell), &other = mesh.surface_of(cell->neighbor(f));
      const auto face = cell->face(f);
      const double n_y = std::abs(face->vertex(1)[0] - face->vertex(0)[0]) / face->measure();
      if (name == other || !drains(scene.regions.at(name), scene.regions.at(other), n_y)) continue;
      list.push_back({name, other, face->vertex(0), face->vertex(1), cell->center(), area_of(cell) / face->measure(),
                      consolidation(scene, scene.regions.at(name), n_y)});
    }
  return list;
}

double smallest_time(const DrainedFace& face, int degree_of_pressure) {
  return face.cell * face.cell / ((degree_of_pressure == 1 ? 6. : 40.) * face.consolidation);
}

double overshoot(const DrainedFace& face, int degree_of_pressure, double time) {
  return between(degree_of_pressure == 1 ? of_degree_1 : of_degree_2,
                 face.consolidation * time / (face.cell * face.cell));
}

std::optional<DrainedLayer> drained_layer(const Scene& scene, const Space& space, const Caisson& caisson, double time) {
  const double B = caisson.bottom_width;
  const auto layers = layers_under(space, caisson);
  const auto faces = faces_under(scene, space.mesh(), caisson);
  double rest = 0.;
  for (const auto& [name, layer] : layers) {
    const double H = layer.area / B, G = layer.G / layer.area;
    rest += faces.count(name) > 0 ? H / (4. * G * (1. + 0.25 * B * B / (H * H))) : H * layer.area / layer.constrained;
  }
  std::optional<DrainedLayer> worst;
  for (const auto& [name, at] : faces) {
    const auto layer = layers.find(name);
    if (layer == layers.end()) continue;
    const Material m = material(scene.regions.at(name), scene.fluid, scene.gravity);
    DrainedLayer found{name, at.into, at.cell / at.length, layer->second.constrained / layer->second.area, 0.,
                       0.,   rest};
    found.skin = std::sqrt(time * m.vertical_flow / m.b / (m.alpha * m.alpha / found.stiffness + m.storage));
    const double drained = found.cell / space.degree();
    found.of_the_rest += found.skin / found.stiffness;
    found.compliance = std::max(drained - found.skin, 0.) * std::min(at.length / B, 1.) / found.stiffness;
    if (!worst || found.compliance > worst->compliance) worst = found;
  }
  return worst;
}

}  // namespace upbead
