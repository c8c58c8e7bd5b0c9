#include "response/wave_resolution.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace upbead {

namespace {

/// From the caisson's bottom (m).
double distance(const dealii::Point<dim>& point, const Caisson& caisson) {
  const double beside = std::max(std::abs(point[0] - caisson.bottom_centre[0]) - 0.5 * caisson.bottom_width, 0.);
  return std::hypot(beside, point[1] - caisson.bottom_centre[1]);
}

}  // namespace

double shear_speed(const Scene& scene, const Mesh& mesh, const dealii::Triangulation<dim>::active_cell_iterator& cell,
                   const SoilState& soil) {
  const Region& region = scene.regions.at(mesh.surface_of(cell));
  if (region.kind != RegionKind::porous && region.kind != RegionKind::solid) return 0.;
  const Material m = material(region, scene.fluid, scene.gravity);
  const double own = soil.shear_modulus.empty() ? 0. : soil.shear_modulus[cell->active_cell_index()];
  return std::sqrt((own > 0. ? own : m.G) / m.rho);
}

std::vector<WaveResolution> wave_resolution(const Scene& scene, const Mesh& mesh, const Caisson& caisson,
                                            double duration, const SoilState& soil) {
  std::map<std::string, WaveResolution> found;
  std::map<std::string, double> area;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& name = mesh.surface_of(cell);
    const double speed = shear_speed(scene, mesh, cell, soil);
    if (name == caisson_name || speed == 0.) continue;
    found[name].speed += speed * cell->measure();
    area[name] += cell->measure();
  }
  for (auto& [name, at] : found) {
    at.region = name;
    at.speed /= area[name];
    at.wavelength = at.speed * duration + caisson.bottom_width;
  }
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (const auto at = found.find(mesh.surface_of(cell)); at != found.end())
      if (distance(cell->center(), caisson) <= at->second.wavelength)
        at->second.cell = std::max(at->second.cell, std::sqrt(cell->measure()));
  std::vector<WaveResolution> list;
  for (const auto& [name, at] : found)
    if (at.cell > 0.) list.push_back(at);
  return list;
}

}  // namespace upbead
