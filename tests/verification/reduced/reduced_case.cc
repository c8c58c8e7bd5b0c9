#include "reduced_case.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead::test {

ShearError error_against(const ModalModel& model, const System& system, double end, double step) {
  const auto scheme = make_scheme(system, {SchemeKind::sdirk4, 0., false});
  const Series marched = march(system, *scheme, make_time_grid(kinks(system), end, step)).ends;
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : system.loads) histories.push_back(load.history);
  const int shear = system.reading("shear_force");
  const Eigen::RowVectorXd truth = marched.reading.row(shear),
                           found = respond(model, sample(histories, marched.time)).reading.row(shear);
  const double peak = truth.cwiseAbs().maxCoeff();
  const double up = std::abs(found.maxCoeff() - truth.maxCoeff()), down = std::abs(found.minCoeff() - truth.minCoeff());
  return {(found - truth).cwiseAbs().maxCoeff() / peak, std::max(up, down) / peak};
}

Scene dry_scene(const TimeFunction& force) {
  Scene scene = breakwater(force);
  for (const char* region : {"seabed", "mound"}) {
    scene.regions[region].flow = Flow::drained;
    scene.regions[region].hydraulic_conductivity.reset();
  }
  for (auto& [name, side] : scene.boundaries) side.pressure.reset();
  scene.time.end = 0.5;
  return scene;
}

Scene sea_scene(const TimeFunction& force, Compressibility compressibility) {
  Scene scene = breakwater(force);
  add_sea(scene);
  for (const char* sea : {"sea_front", "sea_back"}) scene.regions[sea].compressibility = compressibility;
  scene.time.end = 0.5;
  return scene;
}

void write_down(Record& record, const std::string& what, const ShearError& error, Limits limits) {
  record.at_most(what + ": F_T over time, of its peak", error.history, limits.history);
  record.at_most(what + ": peak F_T", error.peak, limits.peak);
}

void compare(Record& record, const std::string& what, const Scene& scene, const Mesh& mesh, Limits limits,
             double step) {
  const Compiled compiled(scene, mesh);
  const Reduction reduction = reduce_scene(compiled.resolved, compiled.scene, {true, false, {}});
  ASSERT_TRUE(reduction.converged) << what;
  if (step == 0.) step = shortest_duration(scene) / 64.;
  write_down(record, what, error_against(reduction.model, compiled.system, scene.time.end, step), limits);
  record.measured(what + ": error that the model states", reduction.error.history);
  record.measured(what + ": vectors per load",
                  reduction.n_vectors / static_cast<double>(reduction.n_independent_loads));
}

Case prototype(const std::vector<std::string>& overrides) {
  return read_case(UPBEAD_CASE_DIR "/fig2b-prototype.toml", overrides);
}

}  // namespace upbead::test
