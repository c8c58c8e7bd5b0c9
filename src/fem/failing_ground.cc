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

FailingGround::FailingGround(const Scene& scene, const Mesh& mesh, const SoilState& state, Fails fails,
                             RestProgress progress)
    : scene_(at_rest(scene)),
      ground_(scene_, mesh, state),
      fails_(std::move(fails)),
      soil_(ground_.space(), ground_.unknowns()),
      x_(Vector::Zero(ground_.unknowns().size())),
      progress_(std::move(progress)) {
  put_on(ground_.weights(water_level(scene, mesh)));
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

void FailingGround::tell(double done) const {
  if (progress_) progress_(done);
}

void FailingGround::start_from_elastic() {
  soil_.follow(StaticLaws(n_cells()));
  soil_.start_from(PointStresses(n_cells()));
  x_.setZero();
  Vector force;
  soil_.exert(x_, force);
  SparseMatrix K = soil_.pattern();
  soil_.tangent(Eigen::Map<Vector>(K.valuePtr(), K.nonZeros()));
  soil_.commit(Factorisation(K).solve(loads_));
  elastic_ = soil_.stresses();
  if (const auto k0 = k0_of(scene_))
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
