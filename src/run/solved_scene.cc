#include "run/solved_scene.h"

#include "base/progress.h"
#include "fem/compile.h"
#include "fem/scene_check.h"
#include "run/accuracy/accuracy.h"
#include "run/contact/contact_run.h"
#include "run/derived.h"
#include "run/safety.h"
#include "run/sliding/case_sliding.h"
#include "run/sliding/coupled_sliding.h"
#include "run/solve.h"
#include "run/yielding_run.h"

namespace upbead {

namespace {

Simulation without_sliding(const Simulation& simulation) {
  if (needs_sliding(simulation.given)) return simulation;
  Scene without = simulation.given;
  without.sliding.reset();
  return with_given(simulation, without);
}

/// About ten marches of the soil come before the run that counts: the part of the work that they are.
double soil_ends(const Simulation& simulation) {
  return follows_strain(simulation.given) && !simulation.soil ? 0.8 : 0.;
}

}  // namespace

bool needs_sliding(const Scene& scene) {
  return has_frictional_contact(scene) || !scene.mesh.refine;
}

SolvedScene::SolvedScene(const Simulation& simulation, const RunOptions& options)
    : simulation_(std::make_shared<const Simulation>(
          with_converged_soil(without_sliding(simulation), part_of(options.progress, 0., soil_ends(simulation))))),
      ahead_(std::make_shared<const Simulation>(with_given(*simulation_, simulation.given))),
      monitors_(*simulation_) {
  const Simulation& solved = *simulation_;
  const bool slips = solved.compiled->system.interface.has_value();
  const double begin = soil_ends(simulation);
  const double bonded_ends =
      slips ? begin + 0.1 * (1. - begin) : begin;  // before contact a bonded run, a tenth as long
  ObserverFunction progress = progress_observer(part_of(options.progress, bonded_ends, 1.));
  MarchOptions marching;
  marching.observers = monitors_.observers();
  marching.observers.push_back(&progress);
  if (MarchObserver* other = options.observer ? options.observer(solved) : nullptr) marching.observers.push_back(other);
  marching.stop_at_energy = solved.given.time.stop_at_energy.value_or(0.);
  marching.checkpoints = options.checkpoints;
  const auto solving = part_of(options.progress, begin, slips ? bonded_ends : 1.);
  solved_ = slips                  ? run_contact(solved, marching, solving, options.soil)
            : yields(solved.scene) ? run_yielding(solved, marching, {}, {true, {{}, {}, options.soil}})
                                   : solve_tied(solved, ahead_, marching, solving);
  if (!solved_.simulation) solved_.simulation = simulation_;
  monitors_.look(solved_);
  solved_.summary.safety = find_safety(solved, solved_.summary);
}

Run SolvedScene::told(Run run, const Scene& given, const std::function<void(double)>& progress) const {
  const auto simulation = std::make_shared<const Simulation>(with_given(*run.simulation, given));
  check_scene(given, *simulation->given_mesh).throw_if_any();
  check_sliding(*simulation);
  run.simulation = simulation;
  if (!run.summary.contact) read_sliding(*simulation, ahead_, run, progress);
  estimate_errors(run);
  monitors_.report(run);
  return run;
}

}  // namespace upbead
