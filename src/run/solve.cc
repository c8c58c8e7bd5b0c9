#include "solve.h"

#include <algorithm>

#include "base/numbers.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "fem/compile.h"
#include "ladder.h"
#include "response/reduction.h"
#include "response/step_choice.h"
#include "size_check.h"
#include "sliding/read_sliding.h"

namespace upbead {

namespace {

/// Steps with contact over those of other schemes of order 2: its stages are a quarter of a step. A 32nd of the
/// duration makes S and peak F_T wrong by less than 0.5 %: docs/slip.md.
constexpr double contact_step = 2.;

/// Per independent load, where nothing but a reduced model is wanted: twice as many as where a march would do as well.
constexpr int most_vectors_by_name = 200;

/// Kinks of the loads and the times at which fields are written.
std::vector<double> times_to_meet(const Scene& scene, const System& system) {
  std::vector<double> times = kinks(system);
  if (scene.fields_every)
    for (int i = 1; i * *scene.fields_every < scene.time.end; ++i) times.push_back(i * *scene.fields_every);
  std::sort(times.begin(), times.end());
  return times;
}

Discretisation discretisation(const Simulation& simulation, const std::string& scheme, const Response& response) {
  Discretisation d;
  d.cells = static_cast<int>(simulation.mesh->triangulation.n_active_cells());
  d.unknowns = simulation.unknowns->n_free();
  d.processes = simulation.processes ? simulation.processes->count() : 1;
  d.degree = simulation.space->degree();
  d.scheme = scheme;
  const std::vector<double>& time = response.ends.time;
  for (std::size_t n = 1; n < time.size(); ++n) d.time_step = std::max(d.time_step, time[n] - time[n - 1]);
  d.steps = response.n_steps;
  d.solves = response.n_solves;
  d.factorisations = response.n_factorisations;
  return d;
}

/// What is read of a response, however it was found.
void summarise(const Simulation& simulation, const std::string& scheme, Run& run) {
  run.summary.discretisation = discretisation(simulation, scheme, run.response);
  if (simulation.compiled->caisson)
    run.summary.response = read_shear_response(*simulation.compiled, run.response, simulation.given.time.inertia);
  if (!run.response.energy.empty()) run.summary.energy = run.response.energy.back();
}

}  // namespace

ReductionSummary summary_of(const Reduction& r) {
  return {r.n_vectors,    r.model.n_modes(), r.error.history,   r.error.peak,
          r.error.others, r.omega / two_pi,  loose_readings(r), r.tolerance_of_others};
}

Run run_march(const Simulation& simulation, const SchemeChoice& choice, const MarchOptions& options, const Care& care) {
  SchemeOptions scheme_options;
  if (choice.scheme == TimeScheme::generalised_alpha) scheme_options.kind = SchemeKind::generalised_alpha;
  scheme_options.refined = care.refined;
  const std::unique_ptr<Scheme> scheme = make_scheme(simulation.compiled->system, scheme_options);
  return march_by(*scheme, simulation, choice.reason, options, care.part);
}

Run march_by(Scheme& scheme, const Simulation& simulation, const std::string& reason, const MarchOptions& options,
             double part) {
  const System& system = simulation.compiled->system;
  const TimeChoice& time = simulation.given.time;
  Run run;
  StepChoice step;
  step.largest_step = time.step.value_or(0.);
  step.reason = "given in the case";
  if (!time.step) {
    step = choose_step(simulation.given, *simulation.compiled, scheme.order());
    if (scheme.contact()) step.largest_step *= contact_step;
  }
  if (part < 1.) {
    step.largest_step *= part;
    if (step.growth) step.growth->largest *= part;
    step.reason = significant(part) + " of those of: " + step.reason;
  }
  if (!time.step || part < 1.) check_steps(simulation.given, step.largest_step, step.growth, step.reason);
  const TimeGrid grid =
      make_time_grid(times_to_meet(simulation.given, system), time.end, step.largest_step, step.growth);

  const Stopwatch watch;
  run.response = march(system, scheme, grid, options);
  run.summary.timing = simulation.timing;
  run.summary.timing.factorise = scheme.factorise_seconds() + step.seconds;
  run.summary.timing.march = watch.seconds() - scheme.factorise_seconds();
  run.response.n_factorisations += step.factorisations;
  run.response.n_solves += step.factorisations;
  run.scheme_reason = reason;
  run.step_reason = step.reason;
  summarise(simulation, scheme.name(), run);
  return run;
}

Run run_reduced(const Simulation& simulation, const SchemeChoice& choice, const std::function<void(double)>& progress) {
  const Stopwatch watch;
  const bool by_name = simulation.given.time.scheme == TimeScheme::reduced;
  const std::optional<int> most_vectors = by_name ? most_vectors_by_name : choice.most_vectors;
  Reduction reduction =
      reduce_scene(simulation.scene, *simulation.compiled, {false, false, most_vectors, true, true}, progress);
  if (by_name)
    require_shear_converged(reduction);
  else
    require_converged(reduction);
  Run run;
  run.response = respond(reduction, simulation.scene, simulation.compiled->system);
  run.summary.timing = simulation.timing;
  run.summary.timing.factorise = reduction.factorise_seconds;
  run.summary.timing.march = watch.seconds() - reduction.factorise_seconds;
  run.scheme_reason = choice.reason;
  run.step_reason = simulation.given.time.step ? "given in the case, or shorter where loads need it"
                                               : "a 32nd of the shortest load, for the record";
  summarise(simulation, "reduced", run);
  run.summary.reduction = summary_of(reduction);
  run.pressures = std::move(reduction.pressures);
  return run;
}

Run run_glued(const Simulation& simulation, const MarchOptions& marching, const std::function<void(double)>& reducing) {
  Run run = climb(simulation, ways(simulation, reducing), marching);
  read_sliding(simulation, run, reducing);
  return run;
}

}  // namespace upbead
