#include "contact_run.h"

#include <algorithm>

#include "../derived.h"
#include "../ladder.h"
#include "contact_demand.h"
#include "contact_recorder.h"
#include "fem/compile.h"
#include "rest_forces.h"
#include "system/interface.h"

namespace upbead {

namespace {

void join(Ladder& ladder, const Ladder& more) {
  ladder.insert(ladder.end(), more.begin(), more.end());
}

/// Friction, and the forces at rest, in sum W' of [sliding] where that is given. Returns the ways tried, if several.
Ladder set_at_rest(const Simulation& simulation, Interface& interface) {
  interface.friction = contact_friction(simulation.scene);
  RestForces rest = rest_forces(simulation, interface);
  interface.normal_force = std::move(rest.normal_force);
  if (simulation.scene.sliding)
    interface.normal_force *= simulation.scene.sliding->buoyant_weight / interface.normal_force.sum();
  return rest.ladder.size() > 1 ? std::move(rest.ladder) : Ladder();
}

/// Takes the forces at the nodes out of what people read.
void remove_node_forces(int n_nodes, System& system, Response& response) {
  const auto n = static_cast<Eigen::Index>(system.readings.size()) - 2 * n_nodes;
  system.readings.resize(static_cast<std::size_t>(n));
  for (Series* series : {&response.ends, &response.balanced}) series->reading.conservativeResize(n, Eigen::NoChange);
}

/// Also fills in what the nodes did.
Run march_contact(const Simulation& simulation, const MarchOptions& marching, const Care& care,
                  ContactSummary& contact) {
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(simulation.compiled->system, true, care.refined);
  ContactRecorder recorder(simulation.compiled->system, *scheme);
  MarchOptions options = marching;
  options.observers.insert(options.observers.begin(), &recorder);
  Run run = march_by(*scheme, simulation, "glued, the caisson would slip or lift at some node", options, care.part);
  contact.solved = recorder.summary();
  run.contact = recorder.history();
  return run;
}

Run climb_contact(const Simulation& simulation, const MarchOptions& marching, ContactSummary& contact) {
  std::vector<Way> ways;
  for (const Care& care : cares_of(simulation.given))
    ways.push_back({name_of_way("contact", care), [&, care](const MarchOptions& options) {
                      return march_contact(simulation, options, care, contact);
                    }});
  return climb(simulation, ways, marching);
}

}  // namespace

Run run_contact(const Simulation& simulation, const MarchOptions& marching,
                const std::function<void(double)>& progress) {
  const auto sliding = std::make_shared<CompiledScene>(*simulation.compiled);
  System& loose = sliding->system;
  const int n_nodes = loose.interface->n_nodes();
  Ladder at_rest = set_at_rest(simulation, *loose.interface);
  const auto tied = std::make_shared<CompiledScene>(*simulation.compiled);
  tied->system = glued(loose, true);
  const Simulation bonded = with_system(simulation, tied);
  ObserverFunction told = progress_observer(progress);
  MarchOptions silent;
  silent.observers = {&told};
  Run run = run_glued(bonded, silent, progress);
  const double margin = run.summary.reduction ? run.summary.reduction->error_of_others : 0.;
  ContactSummary contact{loose.interface->friction,
                         loose.interface->normal_force.sum(),
                         n_nodes,
                         contact_demand(loose, run.response, margin),
                         {}};
  remove_node_forces(n_nodes, tied->system, run.response);
  run.simulation = std::make_shared<const Simulation>(bonded);
  if (contact.demand.reached || simulation.scene.fields_every) {
    const auto moving = std::make_shared<const Simulation>(with_system(simulation, sliding));
    Run solved = climb_contact(*moving, marching, contact);
    solved.simulation = moving;
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
