#include "fem/static_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/ground.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int most_iterations = 50;
constexpr double settled = 1e-3;

/// The lower bound of the mean stress in each region, by its material id.
std::vector<double> floors(const Scene& scene, const Mesh& mesh, const EffectiveStress& stress) {
  std::vector<double> sum(mesh.surfaces.size(), 0.), area(mesh.surfaces.size(), 0.);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const double p = std::max(stress.mean(cell->active_cell_index(), k0_of(scene)), 0.);
    sum[cell->material_id()] += p * area_of(cell);
    area[cell->material_id()] += area_of(cell);
  }
  std::vector<double> list;
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    const std::optional<StressLaw>& law = scene.regions.at(mesh.surfaces[i]).stress_law;
    list.push_back(law && law->floor ? *law->floor : 0.1 * sum[i] / area[i]);
  }
  return list;
}

std::vector<double> moduli(const Scene& scene, const Mesh& mesh, const EffectiveStress& stress) {
  const std::vector<double> floor = floors(scene, mesh, stress);
  std::vector<double> G(mesh.triangulation.n_active_cells(), 0.);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::optional<StressLaw>& law = scene.regions.at(mesh.surface_of(cell)).stress_law;
    const std::size_t i = cell->active_cell_index();
    if (law) G[i] = shear_modulus(*law, stress.mean(i, k0_of(scene)), floor[cell->material_id()]);
    if (law && !(G[i] > 0.))
      throw NumericsError("the static state has no compression in the region '" + mesh.surface_of(cell) +
                          "', so that its stiffness vanishes; give a floor in its shear_modulus");
  }
  return G;
}

double largest_change(const std::vector<double>& before, const std::vector<double>& after) {
  double change = 0.;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (after[i] > 0.) change = std::max(change, std::abs(after[i] / before[i] - 1.));
  return change;
}

/// Moves log G towards log `next`, by `times` times their difference.
void step(std::vector<double>& G, const std::vector<double>& next, double times) {
  for (std::size_t i = 0; i < G.size(); ++i)
    if (next[i] > 0.) G[i] *= std::pow(next[i] / G[i], times);
}

}  // namespace

double EffectiveStress::mean(std::size_t cell, const std::optional<double>& k0) const {
  if (k0) return (1. + 2. * *k0) / 3. * vertical[cell];
  return (horizontal[cell] + vertical[cell] + out_of_plane[cell]) / 3.;
}

std::optional<double> k0_of(const Scene& scene) {
  return scene.initial ? scene.initial->k0 : std::nullopt;
}

bool needs_static_stage(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return entry.second.stress_law.has_value(); });
}

double water_level(const Scene& scene, const Mesh& mesh) {
  if (scene.initial && scene.initial->water_level) return *scene.initial->water_level;
  double level = -std::numeric_limits<double>::infinity();
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (scene.regions.at(mesh.surface_of(cell)).kind == RegionKind::water)
      for (const unsigned v : cell->vertex_indices()) level = std::max(level, cell->vertex(v)[1]);
  return level;
}

Vector static_normal_forces(const Scene& scene, const Mesh& mesh, const SoilState& soil, bool has_settled) {
  const Scene rest = at_rest(scene);
  const Ground ground(rest, mesh, soil, true);
  return ground.normal_forces(ground.weights(water_level(scene, mesh), has_settled));
}

WeightInWater caisson_in_water(const Scene& scene, const Mesh& mesh) {
  const Scene rest = at_rest(scene);
  return Ground(rest, mesh, {}).caisson_in_water(water_level(scene, mesh));
}

/// Stiffer soil attracts load, which stiffens it more: changes of log G shrink by a factor from solve to solve. After
/// every second plain step, one step takes all changes still to come (Aitken).
StaticStage solve_static(const Scene& scene, const Mesh& mesh) {
  const Scene rest = at_rest(scene);
  const Vector weights = Ground(rest, mesh, {}).weights(water_level(scene, mesh));
  StaticStage stage;
  stage.weight = weights.norm();
  SoilState soil;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::optional<StressLaw>& law = scene.regions.at(mesh.surface_of(cell)).stress_law;
    soil.shear_modulus.push_back(law ? law->reference : 0.);
  }
  double last = 0.;
  while (true) {
    stage.stress = Ground(rest, mesh, soil).solve(weights);
    ++stage.iterations;
    stage.shear_modulus = moduli(scene, mesh, stage.stress);
    const double change = largest_change(soil.shear_modulus, stage.shear_modulus);
    if (change < settled) return stage;
    if (stage.iterations == most_iterations)
      throw NumericsError("stiffness and static stress do not settle within " + std::to_string(most_iterations) +
                          " solves");
    const bool stretched = stage.iterations % 3 == 0 && change < 0.9 * last;
    step(soil.shear_modulus, stage.shear_modulus, stretched ? 1. / (1. - change / last) : 1.);
    last = change;
  }
}

}  // namespace upbead
