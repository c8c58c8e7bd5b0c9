#include "findings/ground_section.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "fem/compile.h"
#include "fem/ground.h"
#include "fem/static_stage.h"

namespace upbead {

namespace {

bool is_soil(const Simulation& simulation, const std::string& name) {
  const RegionKind kind = simulation.scene().regions.at(name).kind;
  const auto& caisson = simulation.compiled()->caisson;
  return (kind == RegionKind::porous || kind == RegionKind::solid) && !(caisson && caisson->body.region == name);
}

GroundSoil soil_of(const std::string& name, const Region& region, const Scene& scene) {
  const double density = region.density.value_or(0.);
  GroundSoil soil;
  soil.name = name;
  soil.weight = unit_weight(region, scene, density, false);
  soil.submerged = unit_weight(region, scene, density, true);
  soil.may_fail = region.strength.has_value();
  if (!soil.may_fail) return soil;
  soil.cohesion = region.strength->cohesion;
  soil.friction = std::tan(region.strength->friction_angle * boost::math::constants::degree<double>());
  return soil;
}

using MeshCell = dealii::Triangulation<dim>::active_cell_iterator;

/// The line of a face, with what is below it; none where the cell has the same below and above it, or it is vertical.
std::optional<GroundLine> line_of(const MeshCell& cell, unsigned f, const std::vector<int>& soil) {
  dealii::Point<dim> a = cell->face(f)->vertex(0), b = cell->face(f)->vertex(1);
  if (a[0] > b[0]) std::swap(a, b);
  if (!(b[0] - a[0] > 1e-9 * (std::abs(a[0]) + a.distance(b)))) return std::nullopt;
  const double on_line = a[1] + (cell->center()[0] - a[0]) * (b[1] - a[1]) / (b[0] - a[0]);
  const bool is_below = cell->center()[1] < on_line;
  const int own = soil[cell->material_id()];
  const int other = cell->at_boundary(f) ? no_soil : soil[cell->neighbor(f)->material_id()];
  // of two soils the lower one has the line
  if (own == no_soil || own == other || (!is_below && other != no_soil)) return std::nullopt;
  return GroundLine{{a[0], b[0]}, {a[1], b[1]}, is_below ? own : no_soil};
}

}  // namespace

GroundSection ground_section(const Simulation& simulation) {
  const Mesh& mesh = *simulation.mesh();
  std::vector<GroundSoil> soils;
  std::vector<int> soil;
  for (const std::string& name : mesh.surfaces) {
    soil.push_back(is_soil(simulation, name) ? static_cast<int>(soils.size()) : no_soil);
    if (soil.back() != no_soil) soils.push_back(soil_of(name, simulation.scene().regions.at(name), simulation.scene()));
  }
  std::vector<GroundLine> lines;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      if (const std::optional<GroundLine> line = line_of(cell, f, soil)) lines.push_back(*line);
  const double level = water_level(simulation.scene(), mesh);
  return GroundSection(std::move(soils), std::move(lines), std::isfinite(level) ? std::optional(level) : std::nullopt);
}

}  // namespace upbead
