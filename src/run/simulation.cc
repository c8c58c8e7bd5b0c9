#include "upbead/run/simulation.h"

#include "base/stopwatch.h"
#include "fem/compile.h"
#include "fem/scene_check.h"
#include "run/accuracy/accuracy.h"
#include "run/contact/contact_run.h"
#include "run/derived.h"
#include "run/sliding/case_sliding.h"
#include "system/interface.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

Simulation resolved_on(const Scene& given, std::shared_ptr<const Mesh> mesh,
                       std::shared_ptr<const Processes> processes) {
  check_scene(given, *mesh).throw_if_any();
  Simulation out;
  out.given = given;
  out.given_mesh = out.mesh = std::move(mesh);
  out.processes = std::move(processes);
  ResolvedScene resolved = resolve(given, *out.mesh);
  out.scene = std::move(resolved.scene);
  out.decisions = std::move(resolved.decisions);
  out.absent = std::move(resolved.absent);
  out.soil_state = std::move(resolved.soil);
  out.with_interface = given.mesh.refine && has_frictional_contact(out.scene);
  return out;
}

Simulation on_mesh(const Scene& given, std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Processes> processes) {
  const Stopwatch watch;
  Simulation out = assembled(resolved_on(given, std::move(mesh), std::move(processes)));
  check_sliding(out);
  check_at_rest(out);
  out.timing.compile = watch.seconds();
  return out;
}

Simulation assembled(Simulation simulation) {
  AssembledScene parts = assemble_scene(simulation.scene, *simulation.mesh, simulation.absent, simulation.soil_state,
                                        simulation.with_interface, simulation.processes.get());
  simulation.space = std::move(parts.space);
  simulation.unknowns = std::move(parts.unknowns);
  simulation.compiled = std::move(parts.compiled);
  return simulation;
}

Simulation with_soil(const Simulation& simulation, const SoilState& soil) {
  Simulation other = simulation;
  other.soil_state = soil;
  return assembled(std::move(other));
}

Simulation with_given(const Simulation& simulation, const Scene& given) {
  Simulation other = simulation;
  other.given = given;
  other.scene = given;
  other.scene.regions = simulation.scene.regions;  // resolved
  other.scene.tolerance = simulation.scene.tolerance;
  return other;
}

Simulation with_system(const Simulation& simulation, std::shared_ptr<const CompiledScene> compiled) {
  Simulation other = simulation;
  other.compiled = std::move(compiled);
  return other;
}

Simulation bonded(const Simulation& simulation) {
  if (!simulation.compiled->system.interface) return simulation;
  CompiledScene compiled = *simulation.compiled;
  compiled.system = glued(simulation.compiled->system);
  return with_system(simulation, std::make_shared<CompiledScene>(std::move(compiled)));
}

namespace {

/// Every process adapts the mesh for itself, and all find the same one.
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

}  // namespace

Simulation::Simulation(Scene asked, std::shared_ptr<const Mesh> on, std::shared_ptr<const Processes> among) {
  check_size(asked);
  *this = divided(asked.mesh.refine ? on_mesh(asked, std::move(on), std::move(among))
                                    : adapted_among(asked, std::move(on), std::move(among)));
}

}  // namespace upbead
