#include "base/progress.h"
#include "fem/scene_check.h"
#include "run/contact/contact_run.h"
#include "run/derived.h"
#include "run/sliding/case_sliding.h"
#include "run/solve.h"
#include "run/yielding_run.h"
#include "upbead/base/error.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

/// About ten marches of the soil come before the run that counts: the part of the work that they are.
double soil_ends(const Simulation& simulation) {
  const bool follows = follows_strain(simulation.scene()) || follows_velocity(simulation.scene());
  return follows && !simulation.soil() ? 0.8 : 0.;
}

/// A caisson that cannot slip. Where the scheme that the scene names is refused, the message says whether another one
/// gives a result; contact has only one scheme.
Solution solve_tied(const Simulation& simulation, const Marching& marching) {
  try {
    return run_bonded(simulation, marching);
  } catch (const NumericsError& error) {
    throw NumericsError(error.what() + what_would_work(simulation, marching.beside));
  }
}

}  // namespace

bool needs_sliding(const Scene& scene) {
  return has_frictional_contact(scene) || !scene.mesh.refine;
}

Solution solve(const Simulation& asked, const RunOptions& options) {
  const double begin = soil_ends(asked);
  const auto simulation =
      std::make_shared<const Simulation>(with_converged_soil(asked, part_of(options.progress, 0., begin)));
  const bool slips = simulation->system().interface.has_value(), soil_yields = yields(simulation->scene());
  const double bonded_ends =
      slips ? begin + 0.1 * (1. - begin) : begin;  // before contact a bonded run, a tenth as long
  ObserverFunction progress = progress_observer(part_of(options.progress, bonded_ends, 1.));
  Marching marching;
  marching.observers = {&progress};
  if (MarchObserver* other = options.observer ? options.observer(*simulation) : nullptr)
    marching.observers.push_back(other);
  marching.stop_at_energy = simulation->scene().time.stop_at_energy.value_or(0.);
  marching.checkpoints = options.checkpoints;
  if (slips || !soil_yields) marching.beside = part_of(options.progress, begin, slips ? bonded_ends : 1.);
  marching.soil = options.soil;
  marching.monitored = true;
  return slips         ? run_contact(*simulation, marching)
         : soil_yields ? run_yielding(*simulation, marching)
                       : solve_tied(*simulation, marching);
}

Solution with_sliding(Solution solution, const Scene& given) {
  const auto simulation = std::make_shared<const Simulation>(with_given(*solution.simulation, given));
  check_scene(given, *simulation->given_mesh()).throw_if_any();
  check_sliding(*simulation);
  solution.simulation = simulation;
  return solution;
}

}  // namespace upbead
