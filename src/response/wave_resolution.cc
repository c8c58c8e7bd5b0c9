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
