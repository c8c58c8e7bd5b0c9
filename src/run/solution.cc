#include "base/progress.h"
#include "fem/compile.h"
#include "fem/rest_state.h"
#include "fem/scene_check.h"
#include "run/construction.h"
#include "run/contact/contact_run.h"
#include "run/derived.h"
#include "run/monitors.h"
#include "run/sliding/case_sliding.h"
#include "run/sliding/slip_ahead.h"
#include "run/solve.h"
#include "run/yielding_run.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

Simulation without_sliding(const Simulation& simulation) {
  if (needs_sliding(simulation.given())) return simulation;
  Scene without = simulation.given();
  without.sliding.reset();
  return with_given(simulation, without);
}

/// About ten marches of the soil come before the run that counts: the part of the work that they are.
double soil_ends(const Simulation& simulation) {
  return follows_strain(simulation.scene()) && !simulation.soil() ? 0.8 : 0.;
}

/// Where the scene asks for it, and where its soil has no rest.
std::optional<SafetySummary> safety_of(const Simulation& simulation, const Solution& solution) {
  const Scene& scene = simulation.scene();
  const bool lacks_rest = solution.yielding && !solution.yielding->found.why_no_rest.empty();
  if (!(scene.initial && scene.initial->safety) && !scene.limits.safety && !lacks_rest) return std::nullopt;
  const SafetyFactor found = safety_factor(simulation.scene(), *simulation.mesh(), simulation.soil_state(),
                                           shown_progress("strength reduction"));
  return SafetySummary{found.lower, found.upper, found.fails_at, found.why};
}

}  // namespace

bool needs_sliding(const Scene& scene) {
  return has_frictional_contact(scene) || !scene.mesh.refine;
}

Solution solve(const Simulation& simulation, const RunOptions& options) {
  const double begin = soil_ends(simulation);
  const auto solved = std::make_shared<const Simulation>(
      with_converged_soil(without_sliding(simulation), part_of(options.progress, 0., begin)));
  const auto ahead =
      std::make_shared<SlipAhead>(std::make_shared<const Simulation>(with_given(*solved, simulation.given())));
  const auto monitors = std::make_shared<Monitors>(*solved);
  const bool slips = solved->system().interface.has_value();
  const double bonded_ends =
      slips ? begin + 0.1 * (1. - begin) : begin;  // before contact a bonded run, a tenth as long
  ObserverFunction progress = progress_observer(part_of(options.progress, bonded_ends, 1.));
  MarchOptions marching;
  marching.observers = monitors->observers();
  marching.observers.push_back(&progress);
  if (MarchObserver* other = options.observer ? options.observer(*solved) : nullptr)
    marching.observers.push_back(other);
  marching.stop_at_energy = solved->scene().time.stop_at_energy.value_or(0.);
  marching.checkpoints = options.checkpoints;
  const auto solving = part_of(options.progress, begin, slips ? bonded_ends : 1.);
  Solution solution = slips                     ? run_contact(*solved, marching, solving, options.soil)
                      : yields(solved->scene()) ? run_yielding(*solved, marching, {}, {true, {{}, {}, options.soil}})
                                                : solve_tied(*solved, ahead, marching, solving);
  monitors->look(solution);
  solution.monitors = monitors;
  solution.safety = safety_of(*solved, solution);
  if (!solution.construction) solution.construction = build(*solved);
  return with_sliding(std::move(solution), simulation.given());
}

Solution with_sliding(Solution solution, const Scene& given) {
  const auto simulation = std::make_shared<const Simulation>(with_given(*solution.simulation, given));
  check_scene(given, *simulation->given_mesh()).throw_if_any();
  check_sliding(*simulation);
  solution.simulation = simulation;
  return solution;
}

}  // namespace upbead
