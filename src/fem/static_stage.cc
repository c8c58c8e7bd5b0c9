#include "fem/static_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/construction.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int most_iterations = 50;
constexpr double settled = 1e-3;

/// The lower bound of the mean stress in each region, by its material id.
std::vector<double> floors(const Scene& scene, const Mesh& mesh, const EffectiveStress& stress) {
  std::vector<double> sum(mesh.surfaces.size(), 0.), area(mesh.surfaces.size(), 0.);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const double p = std::max(stress.mean(cell->active_cell_index(), k0_to_apply(scene)), 0.);
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
    if (law) G[i] = shear_modulus(*law, stress.mean(i, k0_to_apply(scene)), floor[cell->material_id()]);
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

/// What is borne when a stage is done; empty before the first.
struct Borne {
  EffectiveStress middle;
  PointStresses points;
};

EffectiveStress sum_of(const EffectiveStress& before, EffectiveStress s) {
  for (std::size_t i = 0; i < before.vertical.size(); ++i) {
    s.horizontal[i] += before.horizontal[i];
    s.vertical[i] += before.vertical[i];
    s.out_of_plane[i] += before.out_of_plane[i];
    s.shear[i] += before.shear[i];
  }
  return s;
}

EffectiveStress by_k0(EffectiveStress s, double k0) {
  for (std::size_t i = 0; i < s.vertical.size(); ++i) s.horizontal[i] = s.out_of_plane[i] = k0 * s.vertical[i];
  return s;
}

/// G at the reference stress where it follows the stress, 0 elsewhere.
SoilState at_reference(const Scene& scene, const Mesh& mesh) {
  SoilState soil;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::optional<StressLaw>& law = scene.regions.at(mesh.surface_of(cell)).stress_law;
    soil.shear_modulus.push_back(law ? law->reference : 0.);
  }
  return soil;
}

/// What a stage adds to `borne`. Stiffer soil attracts load, which stiffens it more: changes of log G shrink by a
/// factor from solve to solve. After every second plain step, one step takes all changes still to come (Aitken).
StaticStage add_stage(const Stage& at, const Mesh& mesh, Borne& borne) {
  const bool in_stages = !at.scene.construction.empty();
  const Ground bare(at.scene, mesh, {});
  const Vector weights = bare.weights(at.level);
  const Vector added = at.is_first ? weights : added_weights(at, bare, borne.points);
  const std::optional<double> k0 = in_stages && at.is_first ? k0_of(at.scene) : std::nullopt;
  StaticStage stage;
  stage.weight = weights.norm();
  SoilState soil = at_reference(at.scene, mesh);
  double last = 0.;
  while (true) {
    const Ground ground(at.scene, mesh, soil);
    const Vector x = ground.displace(added);
    stage.stress = sum_of(borne.middle, ground.stress_in(x));
    if (k0) stage.stress = by_k0(std::move(stage.stress), *k0);
    ++stage.iterations;
    stage.shear_modulus = moduli(at.scene, mesh, stage.stress);
    const double change = largest_change(soil.shear_modulus, stage.shear_modulus);
    if (change < settled) {
      if (in_stages) borne = {stage.stress, stresses_after(ground, borne.points, x)};
      return stage;
    }
    if (stage.iterations == most_iterations)
      throw NumericsError("stiffness and static stress do not settle within " + std::to_string(most_iterations) +
                          " solves");
    const bool stretched = stage.iterations % 3 == 0 && change < 0.9 * last;
    step(soil.shear_modulus, stage.shear_modulus, stretched ? 1. / (1. - change / last) : 1.);
    last = change;
  }
}

/// What is borne before the last stage.
Borne before_last(const std::vector<Stage>& stages, const Mesh& mesh) {
  Borne borne;
  for (std::size_t k = 0; k + 1 < stages.size(); ++k) add_stage(stages[k], mesh, borne);
  return borne;
}

}  // namespace

double EffectiveStress::mean(std::size_t cell, const std::optional<double>& k0) const {
  if (k0) return (1. + 2. * *k0) / 3. * vertical[cell];
  return (horizontal[cell] + vertical[cell] + out_of_plane[cell]) / 3.;
}

std::optional<double> k0_of(const Scene& scene) {
  return scene.initial ? scene.initial->k0 : std::nullopt;
}

std::optional<double> k0_to_apply(const Scene& scene) {
  return scene.construction.empty() ? k0_of(scene) : std::nullopt;
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
  const std::vector<Stage> stages = stages_of(scene, mesh);
  const Stage& last = stages.back();
  const Ground ground(last.scene, mesh, soil, true);
  if (scene.construction.empty()) return ground.normal_forces(ground.weights(last.level, has_settled));
  return ground.normal_forces(added_weights(last, ground, before_last(stages, mesh).points));
}

WeightInWater caisson_in_water(const Scene& scene, const Mesh& mesh) {
  const Scene rest = at_rest(scene);
  return Ground(rest, mesh, {}).caisson_in_water(water_level(scene, mesh));
}

StaticStage solve_static(const Scene& scene, const Mesh& mesh) {
  StaticStage stage;
  Borne borne;
  int iterations = 0;
  std::vector<std::vector<double>> moduli_of_stages;
  for (const Stage& next : stages_of(scene, mesh)) {
    stage = add_stage(next, mesh, borne);
    iterations += stage.iterations;
    if (!scene.construction.empty()) moduli_of_stages.push_back(stage.shear_modulus);
  }
  stage.iterations = iterations;
  stage.in_stages = std::move(moduli_of_stages);
  return stage;
}

}  // namespace upbead
