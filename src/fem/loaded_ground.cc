#include "fem/loaded_ground.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/text.h"
#include "fem/caisson/caisson.h"
#include "fem/factor_search.h"
#include "fem/failing_ground.h"
#include "fem/pore_forces.h"

namespace upbead {

namespace {

/// The caisson as a rigid body: what it puts on the ground is given.
Scene with_rigid_caisson(Scene scene) {
  scene.regions.at(caisson_name).kind = RegionKind::rigid;
  return scene;
}

Vector loads_of(const LoadedMoment& moment, const Ground& ground, double level) {
  Vector loads = ground.weights(level) - ground.weights(level, true) + ground.forces_on_caisson(moment.base);
  if (moment.pores) loads += pore_forces(ground, *moment.pores, moment.pressure);
  return loads;
}

/// How the base moves, by the largest of the motions of its middle and its edges.
std::string told_motion(const dealii::Tensor<1, dim>& middle, double rotation, double width) {
  const double slides = std::abs(middle[0]), sinks = -middle[1], turns = 0.5 * std::abs(rotation) * width;
  const auto way = [](double landward) { return landward > 0. ? " landward" : " seaward"; };
  if (slides >= std::max(sinks, turns)) return std::string("slides") + way(middle[0]);
  return turns >= sinks ? std::string("turns") + way(rotation) : "sinks";
}

double depth_of_work(const std::vector<double>& work, const Mesh& mesh, double base) {
  constexpr double share = 0.95;
  std::vector<std::pair<double, double>> by_height;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (cell->active_cell_index() < work.size())
      by_height.emplace_back(cell->center()[1], work[cell->active_cell_index()]);
  std::sort(by_height.rbegin(), by_height.rend());
  const double all = std::accumulate(work.begin(), work.end(), 0.);
  double sum = 0.;
  for (const auto& [y, part] : by_height)
    if ((sum += part) >= share * all) return base - y;
  return 0.;
}

void tell_failure(const LimitAnswer& answer, const FailingGround& ground, const BaseForces& base, LoadedSafety& found) {
  found.fails_at = ground.name_of(answer.shears_most);
  const auto [middle, rotation] = ground.ground().motion_of_caisson(answer.moved, base.middle);
  found.moves = told_motion(middle, rotation, base.width);
  // a rotation moves a point beside the middle by rotation (dy, -dx)
  found.centre = {base.middle[0] + middle[1] / rotation, base.middle[1] - middle[0] / rotation};
  found.depth = depth_of_work(answer.work, ground.ground().space().mesh(), base.middle[1]);
}

/// The factor under the loads that the ground has; `found` keeps what belongs to another moment if nothing is found.
void seek_factor(FailingGround& ground, const LoadedMoment& moment, double guess, LoadedSafety& found) {
  FactorSearch search(guess, 1.3);
  while (const std::optional<double> F = search.next()) {
    const LimitAnswer answer = ground.bear_at_limit(*F, search.done());
    search.take(*F, answer);
    if (answer.found == RestFound::none && *F == search.upper()) tell_failure(answer, ground, moment.base, found);
  }
  found.lower = search.lower();
  found.upper = search.upper();
  found.why = search.why();
}

}  // namespace

LoadedSafety safety_factor_under(const std::vector<LoadedMoment>& moments, const Scene& scene, const Mesh& mesh,
                                 const SoilState& soil, double guess, const RestProgress& progress) {
  const double level = water_level(scene, mesh);
  FailingGround ground(built_at_once(with_rigid_caisson(scene), mesh), mesh, soil, has_some_strength, progress);
  LoadedSafety found;
  std::string open;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    ground.put_on(loads_of(moments[i], ground.ground(), level));
    if (i > 0) {
      if (!found.lower) continue;
      const LimitAnswer there = ground.bear_at_limit(*found.lower, 0.9);
      if (there.found == RestFound::open) open = "whether another moment is worse was not shown";
      if (there.found != RestFound::none) continue;
      guess = *found.lower * there.factor;
      found.moment = i;
    }
    seek_factor(ground, moments[i], std::clamp(guess, FactorSearch::smallest, FactorSearch::largest), found);
  }
  if (!open.empty()) found.why += (found.why.empty() ? "" : "; ") + open;
  return found;
}

}  // namespace upbead
