#include "yielding_march.h"

#include "dynamics/yielding.h"
#include "fem/compile.h"
#include "fem/soil_laws.h"
#include "fem/yielding_soil.h"

namespace upbead::test {

namespace {

SoilPoints laws_at_rest(const Compiled& compiled, const Mesh& mesh) {
  const RestStart start = compiled.resolved.initial ? compiled.resolved.initial->start : RestStart::k0;
  return soil_laws(compiled.resolved, compiled.space, solve_static(compiled.resolved, mesh).stress, start).points;
}

}  // namespace

YieldingMarch::YieldingMarch(const Scene& scene, const Mesh& mesh, double end, double step, const SoilPoints& points,
                             double tolerance)
    : compiled(scene, mesh) {
  const System& system = compiled.system;
  SoilWork work;
  work.followed = followed_readings(compiled.space, compiled.resolved);
  soil = yielding_soil(compiled.space, compiled.unknowns, system.readings,
                       points ? points : laws_at_rest(compiled, mesh), work);
  const auto scheme = make_yielding_scheme(system, *soil, {tolerance, false});
  response = march(system, *scheme, make_time_grid(kinks(system), end, step));
}

Eigen::RowVectorXd YieldingMarch::history(const std::string& reading) const {
  return test::history(compiled, response, reading);
}

double YieldingMarch::routes() const {
  const auto row = [this](const char* name) {
    return response.balanced.reading.row(compiled.system.reading(name)).eval();
  };
  const auto shear = row("shear_force"), other = row("shear_force_by_inertia");
  return (shear - other).cwiseAbs().maxCoeff() / shear.cwiseAbs().maxCoeff();
}

void give_law(Scene& breakwater, SoilLaw law, double friction_angle, double cohesion) {
  for (const char* soil : {"seabed", "mound"}) {
    breakwater.regions[soil].law = law;
    breakwater.regions[soil].strength = Strength{friction_angle, cohesion, 0., 0.};
  }
  breakwater.initial = InitialState{15., {}};
}

}  // namespace upbead::test
