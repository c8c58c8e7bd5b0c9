#include "case_run.h"

#include "base/stopwatch.h"
#include "case/case_findings.h"
#include "case/case_schema.h"
#include "case/cfd/flow_scene.h"
#include "case/time_end.h"
#include "case/wave_load.h"
#include "findings/histories.h"

namespace upbead {

Scene scene_on(const Case& input, const Mesh& mesh) {
  Scene scene = with_profiles(input, mesh);
  if (end_is_open(input)) scene.time.end = settled_end(input, mesh).seconds;
  place_flows(input, mesh, scene);
  return scene;
}

Simulation simulation_by(
    const Case& input, std::shared_ptr<const Mesh> mesh,
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
  return in_places_of(input, [&] {
    Run run{solve(simulation, options), {}};
    run.summary = find(run, options.progress, case_findings(&input, &records));
    return run;
  });
}

Run answer(const Case& input, const Solution& solution, const std::function<void(double)>& progress) {
  return in_places_of(input, [&] {
    Run run{with_sliding(solution, scene_on(input, *solution.simulation->given_mesh())), {}};
    const std::vector<MeasuredRecord> records = read_records(input, *run.simulation);
    run.summary = find(run, progress, case_findings(&input, &records));
    return run;
  });
}

NumberedWarnings warnings(const Case& input, const Simulation& simulation) {
  return warnings(simulation, case_findings(&input, nullptr));
}

std::vector<Skipped> skipped(const Case& input, const Simulation& simulation, bool reduced) {
  return skipped(simulation, reduced, case_findings(&input, nullptr));
}

}  // namespace upbead
