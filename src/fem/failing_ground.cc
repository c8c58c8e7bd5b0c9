#include "fem/failing_ground.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <utility>

#include "algebra/factorisation.h"
#include "base/text.h"

namespace upbead {

namespace {

constexpr double rad = boost::math::constants::degree<double>();

/// c/F, tan phi/F, tan psi/F.
MohrCoulombStrength reduced(const Strength& s, double F, bool associated) {
  const auto angle = [F](double degrees) { return std::atan(std::tan(degrees * rad) / F) / rad; };
  return {angle(s.friction_angle), s.cohesion / F, angle(associated ? s.friction_angle : s.dilatancy_angle),
          s.tension / F};
}

}  // namespace

bool has_some_strength(const Region& region) {
  return region.strength.has_value();
}

Stage built_at_once(Scene scene, const Mesh& mesh) {
  scene.construction.clear();
  return stages_of(scene, mesh).front();
}

FailingGround::FailingGround(const Stage& stage, const Mesh& mesh, const SoilState& state, Fails fails,
                             RestProgress progress, PointStresses before)
    : stage_(stage),
      ground_(stage_.scene, mesh, state),
      fails_(std::move(fails)),
      before_(std::move(before)),
      soil_(ground_.space(), ground_.unknowns()),
      x_(Vector::Zero(ground_.unknowns().size())),
      progress_(std::move(progress)) {
  if (before_.empty()) before_.resize(n_cells());
  put_on(ground_.weights(stage_.level));
}

void FailingGround::put_on(Vector loads) {
  loads_ = std::move(loads);
  start_from_elastic();
}

StaticReport FailingGround::bear_loads(bool associated, bool patient) {
  soil_.start_from(elastic_);
  x_.setZero();
  soil_.follow(laws(1., associated));
  Vector first;
  soil_.exert(x_, first);
  soil_.commit(x_);
  double share = 0.;
  StaticPath path;
  path.load = [&, first](double next) -> Vector { return share = next, first + next * (loads_ - first); };
  path.each = [&] { tell(share); };
  StaticSteps steps;
  if (!patient) steps.least = steps.to;
  return march_static(soil_, path, steps, x_);
}

LimitAnswer FailingGround::bear_at_limit(double F, double done) {
  soil_.start_from(elastic_);
  soil_.follow(laws(F, true));
  return seek_rest(soil_, loads_, [&] { tell(done); });
}

std::string FailingGround::name_of(unsigned index) const {
  for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
    if (cell->active_cell_index() == index)
      return "region '" + ground_.space().mesh().surface_of(cell) + "' at (" + significant(cell->center()[0], 3) +
             ", " + significant(cell->center()[1], 3) + ") m";
  return {};
}

BuiltStage FailingGround::built(const RestState& rest, bool followed) const {
  BuiltStage built{stage_.name, ground_.weight(stage_.level), rest.stresses, {}, ground_.base_load(stage_.level),
                   {},          rest.share_at_strength};
  if (!followed) return built;
  built.moved = ground_.moved(elastic_move_ + x_);
  built.caisson = ground_.caisson_motion(elastic_move_ + x_);
  return built;
}

void FailingGround::tell(double done) const {
  if (progress_) progress_(done);
}

void FailingGround::start_from_elastic() {
  soil_.follow(StaticLaws(n_cells()));
  soil_.start_from(before_);
  x_.setZero();
  Vector borne;
  soil_.exert(x_, borne);
  SparseMatrix K = soil_.pattern();
  soil_.tangent(Eigen::Map<Vector>(K.valuePtr(), K.nonZeros()));
  elastic_move_ = Factorisation(K).solve(loads_ - borne);
  soil_.commit(elastic_move_);
  elastic_ = soil_.stresses();
  if (const auto k0 = k0_of(stage_.scene); k0 && stage_.is_first)
    for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
      if (fails_(ground_.space().region(cell)))
        for (PlaneStress& s : elastic_[cell->active_cell_index()]) s = {*k0 * s.yy, s.yy, s.xy, *k0 * s.yy};
}

StaticLaws FailingGround::laws(double F, bool associated) const {
  StaticLaws found(n_cells());
  for (const Cell& cell : ground_.space().dofs().active_cell_iterators())
    if (ground_.space().has_matrices(cell) && fails_(ground_.space().region(cell)))
      found[cell->active_cell_index()] = std::make_shared<const MohrCoulombLaw>(
          ground_.space().material(cell), reduced(*ground_.space().region(cell).strength, F, associated));
  return found;
}

}  // namespace upbead
