#include "fem/rest_state.h"

#include <algorithm>

#include "fem/factor_search.h"
#include "fem/failing_ground.h"
#include "model/soil_law_row.h"

namespace upbead {

namespace {

bool starts_balanced(const Region& region) {
  return starts_from(RestStress::balanced, region);
}

}  // namespace

bool needs_rest_state(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return starts_balanced(entry.second); });
}

namespace {

/// Comes to rest in one stage; whether the soil's motion led there.
bool come_to_rest(FailingGround& ground, RestState& rest) {
  bool followed = true;
  rest.report = ground.bear_loads(false, false);
  if (!rest.report.complete) {
    const LimitAnswer limit = ground.bear_at_limit(1., rest.report.reached);
    rest.none = limit.found == RestFound::none;
    if (limit.found != RestFound::rest) rest.gives_way = ground.name_of(limit.shears_most);
    if (!rest.none) rest.report = ground.bear_loads(false, true);
    if (!rest.none && !rest.report.complete) rest.report = ground.bear_loads(true, true);
    if (!rest.report.complete && limit.found == RestFound::rest) {
      ground.soil().start_from(limit.stresses);
      rest.report = {1., 1., true, limit.moved, 1, 0, limit.iterations, limit.residual};
      followed = false;
    }
  }
  rest.found = rest.report.complete;
  if (!rest.found) return followed;
  rest.gives_way.clear();
  rest.stresses = ground.soil().stresses();
  rest.share_at_strength = ground.soil().share_at_strength();
  return followed;
}

/// The stiffness in each stage: where it follows the stress that at its end, and in the last one the given one.
std::vector<SoilState> stiffness_in(const std::vector<Stage>& stages, const Scene& scene, const Mesh& mesh,
                                    const SoilState& soil) {
  std::vector<SoilState> list(stages.size(), soil);
  if (stages.size() == 1 || !needs_static_stage(scene)) return list;
  const std::vector<std::vector<double>> moduli = solve_static(scene, mesh).in_stages;
  for (std::size_t k = 0; k + 1 < stages.size(); ++k) {
    list[k].shear_modulus.resize(moduli[k].size(), 0.);
    for (std::size_t i = 0; i < moduli[k].size(); ++i)
      if (moduli[k][i] > 0.) list[k].shear_modulus[i] = moduli[k][i];
  }
  return list;
}

}  // namespace

RestState rest_state(const Scene& scene, const Mesh& mesh, const SoilState& soil, const RestProgress& progress) {
  const std::vector<Stage> stages = stages_of(scene, mesh);
  const std::vector<SoilState> stiffness = stiffness_in(stages, scene, mesh, soil);
  RestState rest;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const auto n = static_cast<double>(stages.size()), done = static_cast<double>(k);
    const RestProgress part =
        progress ? RestProgress([&progress, n, done](double share) { progress((done + share) / n); }) : RestProgress();
    FailingGround ground(stages[k], mesh, stiffness[k], starts_balanced, part, rest.stresses);
    const int steps = rest.report.steps, iterations = rest.report.iterations;
    const bool followed = come_to_rest(ground, rest);
    rest.report.steps += steps;
    rest.report.iterations += iterations;
    if (!rest.found) {
      rest.falls_in = stages[k].name;
      return rest;
    }
    if (!scene.construction.empty()) rest.built.push_back(ground.built(rest, followed));
  }
  return rest;
}

SafetyFactor safety_factor(const Scene& scene, const Mesh& mesh, const SoilState& soil, const RestProgress& progress) {
  FailingGround ground(built_at_once(scene, mesh), mesh, soil, has_some_strength, progress);
  SafetyFactor found;
  FactorSearch search;
  while (const std::optional<double> F = search.next()) {
    const LimitAnswer answer = ground.bear_at_limit(*F, search.done());
    search.take(*F, answer);
    if (answer.found == RestFound::none && *F == search.upper()) found.fails_at = ground.name_of(answer.shears_most);
  }
  found.lower = search.lower();
  found.upper = search.upper();
  found.why = search.why();
  return found;
}

}  // namespace upbead
