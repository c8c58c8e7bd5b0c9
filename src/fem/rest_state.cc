#include "fem/rest_state.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <functional>
#include <utility>

#include "base/text.h"
#include "fem/ground.h"

namespace upbead {

namespace {

constexpr double rad = boost::math::constants::degree<double>();
/// F is sought between 1/most_reduction and most_reduction, with a relative error of `closeness`.
constexpr double most_reduction = 20., closeness = 0.01;

/// c/F, tan phi/F, tan psi/F.
MohrCoulombStrength reduced(const Strength& s, double F, bool associated) {
  const auto angle = [F](double degrees) { return std::atan(std::tan(degrees * rad) / F) / rad; };
  return {angle(s.friction_angle), s.cohesion / F, angle(associated ? s.friction_angle : s.dilatancy_angle),
          s.tension / F};
}

using Fails = std::function<bool(const Region&)>;

bool follows_mohr_coulomb(const Region& region) {
  return region.law == SoilLaw::mohr_coulomb;
}
bool has_some_strength(const Region& region) {
  return region.strength.has_value();
}

/// Ground at rest whose regions may fail.
class FailingGround {
 public:
  FailingGround(const Scene& scene, const Mesh& mesh, const SoilState& state, Fails fails)
      : scene_(at_rest(scene)),
        ground_(scene_, mesh, state),
        fails_(std::move(fails)),
        weights_(ground_.weights(water_level(scene, mesh))),
        soil_(ground_.space(), ground_.unknowns()),
        x_(Vector::Zero(ground_.unknowns().size())) {}

  /// Applies all weights, with the strength divided by F: the elastic stress is returned to the strength, and the
  /// weights that it then does not bear are applied in steps. Steps from zero stress would be no easier without
  /// cohesion: stresses would only scale.
  StaticReport bear_weights(double F) {
    associated_ = false;
    const StaticReport own = bear_by_flow(F);
    if (own.complete) return own;
    associated_ = true;
    return bear_by_flow(F);
  }

  /// Reduces the strength by growing factors F, from a factor at which the ground stands.
  StaticReport lose_strength(double from) {
    StaticPath path;
    path.load = [&](double) { return weights_; };
    path.laws = [&](double F) { return laws(F); };
    StaticSteps steps;
    steps.from = from;
    steps.to = most_reduction;
    steps.first = 0.1 * from;
    steps.largest = 0.25;
    steps.least = 0.5 * closeness * from;
    return march(path, steps);
  }

  /// Where the last step moved the ground most.
  std::string where_it_moves() const {
    const Vector u = ground_.unknowns().expand(moved_);
    double fastest = 0.;
    std::string where;
    for (const Cell& cell : ground_.space().dofs().active_cell_iterators()) {
      if (!ground_.space().has_matrices(cell)) continue;
      const Dofs dofs = dofs_of(cell);
      for (unsigned i = 0; i < dofs.size(); ++i) {
        if (std::abs(u[dofs[i]]) <= fastest) continue;
        fastest = std::abs(u[dofs[i]]);
        const auto at = node_of(ground_.space(), cell, i).at;
        where = "region '" + ground_.space().mesh().surface_of(cell) + "' at (" + significant(at[0], 3) + ", " +
                significant(at[1], 3) + ") m";
      }
    }
    return where;
  }

  const StaticSoil& soil() const { return soil_; }

 private:
  std::size_t n_cells() const { return ground_.space().mesh().triangulation.n_active_cells(); }

  StaticReport march(const StaticPath& path, const StaticSteps& steps) {
    const StaticReport report = march_static(soil_, path, steps, x_);
    moved_ = report.moved;
    return report;
  }

  StaticReport bear_by_flow(double F) {
    soil_.follow(StaticLaws(n_cells()));
    soil_.start_from(PointStresses(n_cells()));
    x_.setZero();
    start_from_elastic();
    soil_.follow(laws(F));
    Vector first;
    soil_.exert(x_, first);
    soil_.commit(x_);
    StaticPath path;
    path.load = [&, first](double share) -> Vector { return first + share * (weights_ - first); };
    return march(path, {});
  }

  void start_from_elastic() {
    StaticPath path;
    path.load = [&](double) { return weights_; };
    StaticSteps at_once;
    at_once.first = 1.;
    march_static(soil_, path, at_once, x_);
    x_.setZero();
    PointStresses stresses = soil_.stresses();
    if (const auto k0 = k0_of(scene_))
      for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
        if (fails_(ground_.space().region(cell)))
          for (PlaneStress& s : stresses[cell->active_cell_index()]) s = {*k0 * s.yy, s.yy, s.xy, *k0 * s.yy};
    soil_.start_from(stresses);
  }

  StaticLaws laws(double F) const {
    StaticLaws found(n_cells());
    for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
      if (ground_.space().has_matrices(cell) && fails_(ground_.space().region(cell)))
        found[cell->active_cell_index()] = std::make_shared<const MohrCoulombLaw>(
            ground_.space().material(cell), reduced(*ground_.space().region(cell).strength, F, associated_));
    return found;
  }

  Scene scene_;
  Ground ground_;
  Fails fails_;
  Vector weights_;
  StaticSoil soil_;
  Vector x_, moved_;
  bool associated_ = false;
};

}  // namespace

bool needs_rest_state(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return follows_mohr_coulomb(entry.second); });
}

RestState rest_state(const Scene& scene, const Mesh& mesh, const SoilState& soil) {
  FailingGround ground(scene, mesh, soil, follows_mohr_coulomb);
  RestState rest;
  rest.report = ground.bear_weights(1.);
  rest.found = rest.report.complete;
  if (!rest.found) {
    rest.gives_way = ground.where_it_moves();
    return rest;
  }
  rest.stresses = ground.soil().stresses();
  rest.share_at_strength = ground.soil().share_at_strength();
  return rest;
}

SafetyFactor safety_factor(const Scene& scene, const Mesh& mesh, const SoilState& soil) {
  FailingGround ground(scene, mesh, soil, has_some_strength);
  SafetyFactor found;
  for (double F = 1.; F > 1. / most_reduction; F *= 0.5) {
    if (!ground.bear_weights(F).complete) {
      found.upper = F;
      found.fails_at = ground.where_it_moves();
      continue;
    }
    const StaticReport report = ground.lose_strength(F);
    found.lower = report.reached;
    if (!report.complete) {
      found.upper = found.upper ? std::min(*found.upper, report.failed) : report.failed;
      found.fails_at = ground.where_it_moves();
    }
    break;
  }
  return found;
}

}  // namespace upbead
