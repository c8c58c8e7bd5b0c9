#include "fem/rest_state.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <functional>
#include <utility>

#include "algebra/factorisation.h"
#include "base/text.h"
#include "fem/factor_search.h"
#include "fem/limit_state.h"
#include "model/soil_law_row.h"

namespace upbead {

namespace {

constexpr double rad = boost::math::constants::degree<double>();

/// c/F, tan phi/F, tan psi/F.
MohrCoulombStrength reduced(const Strength& s, double F, bool associated) {
  const auto angle = [F](double degrees) { return std::atan(std::tan(degrees * rad) / F) / rad; };
  return {angle(s.friction_angle), s.cohesion / F, angle(associated ? s.friction_angle : s.dilatancy_angle),
          s.tension / F};
}

using Fails = std::function<bool(const Region&)>;

bool starts_balanced(const Region& region) {
  return starts_from(RestStress::balanced, region);
}
bool has_some_strength(const Region& region) {
  return region.strength.has_value();
}

/// Ground at rest whose regions may fail.
class FailingGround {
 public:
  /// `before`: stresses of the last stage; empty before the first.
  FailingGround(const Stage& stage, const Mesh& mesh, const SoilState& state, Fails fails, RestProgress progress,
                const PointStresses& before = {})
      : stage_(stage),
        ground_(stage_.scene, mesh, state),
        fails_(std::move(fails)),
        weights_(ground_.weights(stage_.level)),
        soil_(ground_.space(), ground_.unknowns()),
        x_(Vector::Zero(ground_.unknowns().size())),
        progress_(std::move(progress)) {
    start_from_elastic(before.empty() ? PointStresses(n_cells()) : before);
  }

  /// Applies all weights in steps: the elastic stress is returned to the strength, and the weights that it then does
  /// not bear are applied. Steps from zero stress would be no easier without cohesion: stresses would only scale.
  /// `patient`: a step that fails is cut.
  StaticReport bear_weights(bool associated, bool patient) {
    soil_.start_from(elastic_);
    x_.setZero();
    soil_.follow(laws(1., associated));
    Vector first;
    soil_.exert(x_, first);
    soil_.commit(x_);
    double share = 0.;
    StaticPath path;
    path.load = [&, first](double next) -> Vector { return share = next, first + next * (weights_ - first); };
    path.each = [&] { tell(share); };
    StaticSteps steps;
    if (!patient) steps.least = steps.to;
    return march_static(soil_, path, steps, x_);
  }

  /// Whether any stress bears the weights within the strength over F.
  LimitAnswer bear_at_limit(double F, double done) {
    soil_.start_from(elastic_);
    soil_.follow(laws(F, true));
    return seek_rest(soil_, weights_, [&] { tell(done); });
  }

  std::string name_of(unsigned index) const {
    for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
      if (cell->active_cell_index() == index)
        return "region '" + ground_.space().mesh().surface_of(cell) + "' at (" + significant(cell->center()[0], 3) +
               ", " + significant(cell->center()[1], 3) + ") m";
    return {};
  }

  StaticSoil& soil() { return soil_; }

  /// `followed`: whether the motion led to these stresses; where it did not, it is not known.
  BuiltStage built(const RestState& rest, bool followed) const {
    BuiltStage built{stage_.name, ground_.weight(stage_.level), rest.stresses, {}, ground_.base_load(stage_.level),
                     {},          rest.share_at_strength};
    if (!followed) return built;
    built.moved = ground_.moved(elastic_move_ + x_);
    built.caisson = ground_.caisson_motion(elastic_move_ + x_);
    return built;
  }

 private:
  std::size_t n_cells() const { return ground_.space().mesh().triangulation.n_active_cells(); }

  void tell(double done) const {
    if (progress_) progress_(done);
  }

  void start_from_elastic(const PointStresses& before) {
    soil_.follow(StaticLaws(n_cells()));
    soil_.start_from(before);
    Vector borne;
    soil_.exert(x_, borne);
    SparseMatrix K = soil_.pattern();
    soil_.tangent(Eigen::Map<Vector>(K.valuePtr(), K.nonZeros()));
    elastic_move_ = Factorisation(K).solve(weights_ - borne);
    soil_.commit(elastic_move_);
    elastic_ = soil_.stresses();
    if (const auto k0 = k0_of(stage_.scene); k0 && stage_.is_first)
      for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
        if (fails_(ground_.space().region(cell)))
          for (PlaneStress& s : elastic_[cell->active_cell_index()]) s = {*k0 * s.yy, s.yy, s.xy, *k0 * s.yy};
  }

  StaticLaws laws(double F, bool associated) const {
    StaticLaws found(n_cells());
    for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
      if (ground_.space().has_matrices(cell) && fails_(ground_.space().region(cell)))
        found[cell->active_cell_index()] = std::make_shared<const MohrCoulombLaw>(
            ground_.space().material(cell), reduced(*ground_.space().region(cell).strength, F, associated));
    return found;
  }

  Stage stage_;
  Ground ground_;
  Fails fails_;
  Vector weights_;
  StaticSoil soil_;
  Vector elastic_move_, x_;  ///< of the elastic ground; of the soil after that
  PointStresses elastic_;
  RestProgress progress_;
};

}  // namespace

bool needs_rest_state(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return starts_balanced(entry.second); });
}

namespace {

/// Comes to rest in one stage; whether the soil's motion led there.
bool come_to_rest(FailingGround& ground, RestState& rest) {
  bool followed = true;
  rest.report = ground.bear_weights(false, false);
  if (!rest.report.complete) {
    const LimitAnswer limit = ground.bear_at_limit(1., rest.report.reached);
    rest.none = limit.found == RestFound::none;
    if (limit.found != RestFound::rest) rest.gives_way = ground.name_of(limit.shears_most);
    if (!rest.none) rest.report = ground.bear_weights(false, true);
    if (!rest.none && !rest.report.complete) rest.report = ground.bear_weights(true, true);
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
  Scene at_once = scene;  // whether any stress is in equilibrium does not depend on how the section was built
  at_once.construction.clear();
  FailingGround ground(stages_of(at_once, mesh).front(), mesh, soil, has_some_strength, progress);
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
