#include "response/drained_layer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "response/drained_skin.h"

namespace upbead {

namespace {

bool is_under(const dealii::Point<dim>& point, const Caisson& caisson) {
  return std::abs(point[0] - caisson.bottom_centre[0]) < 0.5 * caisson.bottom_width &&
         point[1] < caisson.bottom_centre[1] && point[1] > caisson.bottom_centre[1] - caisson.bottom_width;
}

/// A region under the caisson, to the depth of a width.
struct Layer {
  double area = 0.;                 ///< m2
  double G = 0., constrained = 0.;  ///< times the area (Pa m2)
};

std::map<std::string, Layer> layers_under(const Space& space, const Caisson& caisson) {
  std::map<std::string, Layer> layers;
  for (const auto& cell : space.mesh().triangulation.active_cell_iterators()) {
    const std::string& name = space.mesh().surface_of(cell);
    const ElasticLaw& law = space.material(cell);
    if (name == caisson_name || law.G == 0. || !is_under(cell->center(), caisson)) continue;
    Layer& layer = layers[name];
    layer.area += cell->measure();
    layer.G += law.G * cell->measure();
    layer.constrained += law.constrained_modulus() * cell->measure();
  }
  return layers;
}

/// Where water leaves the regions that drain.
struct Faces {
  std::string into;
  double length = 0., cell = 0.;  ///< m; cell times length
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
    found.skin = std::sqrt(time / m.b / (m.alpha * m.alpha / found.stiffness + m.storage));
    const double drained = found.cell / space.degree();
    found.of_the_rest += found.skin / found.stiffness;
    found.compliance = std::max(drained - found.skin, 0.) * std::min(at.length / B, 1.) / found.stiffness;
    if (!worst || found.compliance > worst->compliance) worst = found;
  }
  return worst;
}

}  // namespace upbead
