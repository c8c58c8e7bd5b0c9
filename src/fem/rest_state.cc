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

RestState rest_state(const Scene& scene, const Mesh& mesh, const SoilState& soil, const RestProgress& progress) {
  FailingGround ground(scene, mesh, soil, starts_balanced, progress);
  RestState rest;
  rest.report = ground.bear_loads(false, false);
  if (!rest.report.complete) {
    const LimitAnswer limit = ground.bear_at_limit(1., rest.report.reached);
    rest.none = limit.found == RestFound::none;
    if (limit.found != RestFound::rest) rest.gives_way = ground.name_of(limit.shears_most);
    if (rest.none) return rest;
    rest.report = ground.bear_loads(false, true);
    if (!rest.report.complete) rest.report = ground.bear_loads(true, true);
    if (!rest.report.complete && limit.found == RestFound::rest) {
      ground.soil().start_from(limit.stresses);
      rest.report = {1., 1., true, limit.moved, 1, 0, limit.iterations, limit.residual};
    }
  }
  rest.found = rest.report.complete;
  if (!rest.found) return rest;
  rest.gives_way.clear();
  rest.stresses = ground.soil().stresses();
  rest.share_at_strength = ground.soil().share_at_strength();
  return rest;
}

SafetyFactor safety_factor(const Scene& scene, const Mesh& mesh, const SoilState& soil, const RestProgress& progress) {
  FailingGround ground(scene, mesh, soil, has_some_strength, progress);
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
