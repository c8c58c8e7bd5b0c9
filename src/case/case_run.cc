#include "case_run.h"

#include "base/stopwatch.h"
#include "case/case_findings.h"
#include "case/case_schema.h"
#include "case/cfd/flow_scene.h"
#include "case/wave_load.h"
#include "findings/histories.h"

namespace upbead {

namespace {

/// The case's scene with what follows with the mesh: profiles, its end, pieces of its loads.
Scene scene_on(const Case& input, const Mesh& mesh, double end) {
  Scene scene = with_profiles(input, mesh);
  scene.time.end = end;
  place_flows(input, mesh, scene);
  return scene;
}

}  // namespace

Scene scene_on(const Case& input, const Mesh& mesh) {
  return scene_on(input, mesh, end_on(input, mesh));
}

Simulation simulation_by(const Case& input, std::shared_ptr<const Mesh> mesh,
                         const std::function<Simulation(Scene scene, const std::shared_ptr<const Mesh>& mesh)>& make) {
  return in_places_of(input, [&] {
    check_size(input.scene);
    const Stopwatch watch;
    if (!mesh) mesh = read_mesh(mesh_request(input));
    const double seconds = watch.seconds();
    const Simulation simulation = make(scene_on(input, *mesh), mesh);
    check_waves(input, simulation);
    return simulation.with([&](auto& parts) { parts.timing.mesh += seconds; });
  });
}

Simulation simulation_of(const Case& input, std::shared_ptr<const Mesh> mesh,
                         std::shared_ptr<const Processes> processes) {
  return simulation_by(input, std::move(mesh), [&](Scene scene, const std::shared_ptr<const Mesh>& on) {
    return Simulation(std::move(scene), on, processes);
  });
}

Simulation simulation_after(const Simulation* before, const Case& input, std::shared_ptr<const Mesh> mesh) {
  if (before == nullptr) return simulation_of(input, std::move(mesh));
  return simulation_by(input, std::move(mesh), [&](Scene scene, const std::shared_ptr<const Mesh>& on) {
    return Simulation(std::move(scene), on, *before);
  });
}

std::vector<MeasuredRecord> read_records(const Case& input, const Simulation& simulation) {
  return input.tables->measured.empty() ? std::vector<MeasuredRecord>()
                                        : read_measured(input, names_of_histories(simulation));
}

Run solve(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& records,
          const RunOptions& options) {
  return in_places_of(
      input, [&] { return run_of(solve(simulation, options), options.progress, case_findings(&input, &records)); });
}

Run solve(const Case& input, const Simulation& simulation, const RunOptions& options) {
  return solve(input, simulation, read_records(input, simulation), options);
}

Run answer(const Case& input, const Solution& solution, const std::function<void(double)>& progress) {
  return in_places_of(input, [&] {
    const Simulation& solved = *solution.simulation;
    Solution same = with_sliding(solution, scene_on(input, *solved.given_mesh(), solved.given().time.end));
    const std::vector<MeasuredRecord> records = read_records(input, *same.simulation);
    return run_of(std::move(same), progress, case_findings(&input, &records));
  });
}

NumberedWarnings warnings(const Case& input, const Simulation& simulation) {
  return warnings(simulation, case_findings(&input, nullptr));
}

std::vector<Skipped> skipped(const Case& input, const Simulation& simulation, bool reduced) {
  return skipped(simulation, reduced, case_findings(&input, nullptr));
}

}  // namespace upbead
