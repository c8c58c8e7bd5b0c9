#include "contact_run.h"

#include <algorithm>

#include "../solve.h"
#include "contact_demand.h"
#include "contact_recorder.h"
#include "upbead/base/error.h"
#include "upbead/base/text.h"
#include "upbead/fem/static_stage.h"
#include "upbead/system/interface.h"

namespace upbead {

namespace {

/// Friction, and the forces at rest: as the static state distributes them, in sum W' of [sliding] where that is given.
void set_at_rest(const CompiledCase& scene, Interface& interface) {
  interface.friction = contact_friction(scene.scene);
  interface.normal_force = static_normal_forces(scene.scene, *scene.mesh, scene.soil_state);
  const double sum = interface.normal_force.sum();
  Eigen::Index least = 0;
  if (!(interface.normal_force.minCoeff(&least) > 0.))
    throw NumericsError("at rest the caisson pulls on its ground at x = " +
                        significant(interface.position[static_cast<std::size_t>(least)]) + " m: its weight in water, " +
                        significant(sum) + " N/m, does not press the whole bottom down");
  if (scene.scene.sliding) interface.normal_force *= scene.scene.sliding->buoyant_weight / sum;
}

/// Takes the forces at the nodes out of what people read.
void remove_node_forces(int n_nodes, System& system, Response& response) {
  const auto n = static_cast<Eigen::Index>(system.readings.size()) - 2 * n_nodes;
  system.readings.resize(static_cast<std::size_t>(n));
  for (Series* series : {&response.ends, &response.balanced}) series->reading.conservativeResize(n, Eigen::NoChange);
}

/// Also fills in what the nodes did.
Run march_contact(const Case& input, const CompiledCase& scene, const MarchOptions& marching, ContactSummary& contact) {
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(scene.compiled.system);
  ContactRecorder recorder(scene.compiled.system, *scheme);
  MarchOptions options = marching;
  options.observer = [&](const State& state, int step, int n) {
    recorder.see(state);
    if (marching.observer) marching.observer(state, step, n);
  };
  Run run = march_by(*scheme, input, scene, "glued, the caisson would slip or lift at some node", options);
  contact.solved = recorder.summary();
  run.contact = recorder.history();
  return run;
}

}  // namespace

Run run_contact(const Case& input, CompiledCase& scene, const MarchOptions& marching,
                const std::function<void(double)>& progress) {
  System loose = std::move(scene.compiled.system);
  const int n_nodes = loose.interface->n_nodes();
  set_at_rest(scene, *loose.interface);
  scene.compiled.system = glued(loose, true);
  MarchOptions silent;
  silent.observer = [&progress](const State&, int step, int n) {
    if (progress) progress(n > 0 ? static_cast<double>(step) / n : 1.);
  };
  Run run = run_glued(input, scene, silent, progress);
  const double margin = run.summary.reduction ? run.summary.reduction->error_of_others : 0.;
  ContactSummary contact{loose.interface->friction,
                         loose.interface->normal_force.sum(),
                         n_nodes,
                         contact_demand(loose, run.response, margin),
                         {}};
  remove_node_forces(n_nodes, scene.compiled.system, run.response);
  if (contact.demand.reached || scene.scene.fields_every) {
    scene.compiled.system = std::move(loose);
    Run solved = march_contact(input, scene, marching, contact);
    solved.summary.sliding = run.summary.sliding;
    solved.summary.error = run.summary.error;
    solved.coupled = run.coupled;
    solved.summary.timing.factorise += run.summary.timing.factorise;
    solved.summary.timing.march += run.summary.timing.march;
    run = std::move(solved);
  }
  run.summary.contact = contact;
  return run;
}

}  // namespace upbead
