#include "response/drained_skin.h"

#include <array>
#include <cmath>

namespace upbead {

namespace {

constexpr double least_contrast = 10.;  ///< of conductivities

bool has_pore_pressure(const Region& region) {
  return region.kind == RegionKind::porous && region.flow != Flow::drained;
}

bool drains(const Region& soil, const Region& other) {
  if (!has_pore_pressure(soil)) return false;
  if (other.kind == RegionKind::water) return true;
  return has_pore_pressure(other) && *other.hydraulic_conductivity >= least_contrast * *soil.hydraulic_conductivity;
}

double consolidation(const Scene& scene, const Region& region) {
  const Material m = material(region, scene.fluid, scene.gravity);
  return 1. / m.b / (m.alpha * m.alpha / m.constrained_modulus() + m.storage);
}

/// c_v t / h^2, and the overshoot after that time.
using Table = std::array<std::array<double, 2>, 7>;
constexpr Table of_degree_1{
    {{1e-3, 0.257}, {0.01, 0.240}, {0.025, 0.202}, {0.05, 0.145}, {0.1, 0.048}, {1. / 6., 0.036}, {2., 0.}}};
constexpr Table of_degree_2{
    {{1e-3, 0.134}, {0.01, 0.069}, {0.025, 0.007}, {0.05, 0.007}, {0.1, 0.002}, {1. / 6., 0.001}, {2., 0.}}};

/// Straight over the logarithm, and constant beyond the ends.
double between(const Table& table, double ratio) {
  if (ratio <= table.front()[0]) return table.front()[1];
  for (std::size_t i = 0; i + 1 < table.size(); ++i) {
    const auto& [low, at_low] = table[i];
    const auto& [high, at_high] = table[i + 1];
    if (ratio <= high) return at_low + (at_high - at_low) * std::log(ratio / low) / std::log(high / low);
  }
  return table.back()[1];
}

}  // namespace

std::vector<DrainedFace> drained_faces(const Scene& scene, const Mesh& mesh) {
  std::vector<DrainedFace> list;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f)) continue;
      const std::string &name = mesh.surface_of(cell), &other = mesh.surface_of(cell->neighbor(f));
      if (name == other || !drains(scene.regions.at(name), scene.regions.at(other))) continue;
      const auto face = cell->face(f);
      list.push_back({name, other, face->vertex(0), face->vertex(1), cell->center(), cell->measure() / face->measure(),
                      consolidation(scene, scene.regions.at(name))});
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

}  // namespace upbead
