#include "upbead/run/simulation.h"

#include "accuracy/adapt.h"
#include "accuracy/error_account.h"
#include "base/stopwatch.h"
#include "contact/contact_run.h"
#include "derived.h"
#include "fem/compile.h"
#include "ladder.h"
#include "run_warnings.h"
#include "system/part.h"
#include "upbead/base/error.h"
#include "warnings/scene_watch.h"

namespace upbead {

namespace {

/// On the mesh that all processes have found alike, each for itself.
Simulation adapted_among(const Scene& given, std::shared_ptr<const Mesh> mesh,
                         std::shared_ptr<const Processes> processes) {
  Simulation simulation = adapted(given, std::move(mesh));
  simulation.with_interface = has_frictional_contact(simulation.scene);
  if (!processes && !simulation.with_interface) return simulation;
  const Stopwatch watch;
  simulation.processes = std::move(processes);
  simulation = assembled(std::move(simulation));
  simulation.timing.compile += watch.seconds();
  return simulation;
}

Simulation divided(Simulation simulation) {
  if (!simulation.processes) return simulation;
  const Stopwatch watch;
  CompiledScene compiled = *simulation.compiled;
  const std::vector<int> index = divide(compiled.system, compiled.body_coordinates, simulation.processes);
  for (int& i : compiled.body_coordinates) i = index[static_cast<std::size_t>(i)];
  simulation.compiled = std::make_shared<CompiledScene>(std::move(compiled));
  simulation.timing.compile += watch.seconds();
  return simulation;
}

/// A scene that names a scheme is told, where that is refused, whether another one answers. Contact has but one.
Run solve_bonded(const Simulation& simulation, const MarchOptions& marching,
                 const std::function<void(double)>& progress) {
  try {
    return run_glued(simulation, marching, progress);
  } catch (const NumericsError& error) {
    throw NumericsError(error.what() + what_would_work(simulation, progress));
  }
}

}  // namespace

Simulation::Simulation(Scene asked, std::shared_ptr<const Mesh> on, std::shared_ptr<const Processes> among) {
  check_size(asked);
  *this = divided(asked.mesh.refine ? on_mesh(asked, std::move(on), std::move(among))
                                    : adapted_among(asked, std::move(on), std::move(among)));
}

Run Simulation::run(const RunOptions& options) const {
  const Simulation solved = with_converged_soil(*this, options.progress);
  SceneWatch watch(solved);
  ObserverFunction progress = progress_observer(options.progress);
  MarchOptions marching;
  marching.observers = watch.observers();
  marching.observers.push_back(&progress);
  if (MarchObserver* other = options.observer ? options.observer(solved) : nullptr) marching.observers.push_back(other);
  marching.stop_at_energy = given.time.stop_at_energy.value_or(0.);
  marching.checkpoints = options.checkpoints;
  Run run = solved.compiled->system.interface ? run_contact(solved, marching, options.progress)
                                              : solve_bonded(solved, marching, options.progress);
  if (!run.simulation) run.simulation = std::make_shared<const Simulation>(solved);
  estimate_errors(run);
  tell(watch, run);
  return run;
}

}  // namespace upbead
