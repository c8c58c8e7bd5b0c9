#include "contact_run.h"

#include <algorithm>

#include "../ladder.h"
#include "contact_demand.h"
#include "contact_recorder.h"
#include "rest_forces.h"
#include "upbead/system/interface.h"

namespace upbead {

namespace {

void join(Ladder& ladder, const Ladder& more) {
  ladder.insert(ladder.end(), more.begin(), more.end());
}

/// Friction, and the forces at rest, in sum W' of [sliding] where that is given. Returns the ways tried, if several.
Ladder set_at_rest(const CompiledCase& scene, Interface& interface) {
  interface.friction = contact_friction(scene.scene);
  RestForces rest = rest_forces(scene, interface);
  interface.normal_force = std::move(rest.normal_force);
  if (scene.scene.sliding) interface.normal_force *= scene.scene.sliding->buoyant_weight / interface.normal_force.sum();
  return rest.ladder.size() > 1 ? std::move(rest.ladder) : Ladder();
}

/// Takes the forces at the nodes out of what people read.
void remove_node_forces(int n_nodes, System& system, Response& response) {
  const auto n = static_cast<Eigen::Index>(system.readings.size()) - 2 * n_nodes;
  system.readings.resize(static_cast<std::size_t>(n));
  for (Series* series : {&response.ends, &response.balanced}) series->reading.conservativeResize(n, Eigen::NoChange);
}

/// Also fills in what the nodes did.
Run march_contact(const Case& input, const CompiledCase& scene, const MarchOptions& marching, const Care& care,
                  ContactSummary& contact) {
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(scene.compiled.system, true, care.refined);
  ContactRecorder recorder(scene.compiled.system, *scheme);
  MarchOptions options = marching;
  options.observer = [&](const State& state, int step, int n) {
    recorder.see(state);
    if (marching.observer) marching.observer(state, step, n);
  };
  Run run = march_by(*scheme, input, scene, "glued, the caisson would slip or lift at some node", options, care.part);
  contact.solved = recorder.summary();
  run.contact = recorder.history();
  return run;
}

Run climb_contact(const Case& input, const CompiledCase& scene, const MarchOptions& marching, ContactSummary& contact) {
  std::vector<Way> ways;
  for (const Care& care : cares_of(input))
    ways.push_back({name_of_way("contact", care), [&, care](const MarchOptions& options) {
                      return march_contact(input, scene, options, care, contact);
                    }});
  return climb(input, scene, ways, marching);
}

}  // namespace

Run run_contact(const Case& input, CompiledCase& scene, const MarchOptions& marching,
                const std::function<void(double)>& progress) {
  System loose = std::move(scene.compiled.system);
  const int n_nodes = loose.interface->n_nodes();
  Ladder at_rest = set_at_rest(scene, *loose.interface);
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
    Run solved = climb_contact(input, scene, marching, contact);
    solved.summary.sliding = run.summary.sliding;
    solved.coupled = run.coupled;
    join(run.summary.ladder, solved.summary.ladder);
    solved.summary.ladder = std::move(run.summary.ladder);
    solved.summary.timing.factorise += run.summary.timing.factorise;
    solved.summary.timing.march += run.summary.timing.march;
    run = std::move(solved);
  }
  join(at_rest, run.summary.ladder);
  run.summary.ladder = std::move(at_rest);
  run.summary.contact = contact;
  return run;
}

}  // namespace upbead
