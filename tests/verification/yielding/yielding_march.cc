#include "yielding_march.h"

namespace upbead::test {

namespace {

PointsOfCells laws_at_rest(const Compiled& compiled, const Mesh& mesh) {
  const RestStart start = compiled.resolved.initial ? compiled.resolved.initial->start : RestStart::k0;
  return soil_laws(compiled.resolved, compiled.space, solve_static(compiled.resolved, mesh).stress, start).points;
}

}  // namespace

YieldingMarch::YieldingMarch(const Scene& scene, const Mesh& mesh, double end, double step) : compiled(scene, mesh) {
  const System& system = compiled.scene.system;
  SoilWork work;
  work.followed = followed_readings(compiled.space, compiled.resolved);
  soil = yielding_soil(compiled.space, compiled.unknowns, system.readings, laws_at_rest(compiled, mesh), work);
  const auto scheme = make_yielding_scheme(system, *soil, {1e-9, false});
  response = march(system, *scheme, make_time_grid(kinks(system), end, step));
}

Eigen::RowVectorXd YieldingMarch::history(const std::string& reading) const {
  return test::history(compiled, response, reading);
}

}  // namespace upbead::test
