#include "derived.h"

#include "base/stopwatch.h"
#include "contact/rest_forces.h"
#include "fem/compile.h"
#include "fem/scene_check.h"
#include "sliding/case_sliding.h"
#include "system/interface.h"
#include "upbead/base/error.h"

namespace upbead {

Simulation on_mesh(const Scene& given, std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Processes> processes) {
  const Stopwatch watch;
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
  out = assembled(std::move(out));
  check_sliding(out);
  check_at_rest(out);
  out.timing.compile = watch.seconds();
  return out;
}

Simulation assembled(Simulation simulation) {
  simulation.space =
      std::make_shared<Space>(*simulation.mesh, simulation.scene, simulation.absent, simulation.soil_state);
  const std::vector<Body> bodies = rigid_bodies(*simulation.space);
  const std::vector<InterfaceNode> nodes =
      simulation.with_interface ? interface_nodes(*simulation.space) : std::vector<InterfaceNode>();
  simulation.unknowns = std::make_shared<Unknowns>(*simulation.space, simulation.scene, bodies, nodes);
  simulation.compiled = std::make_shared<CompiledScene>(
      compile(simulation.scene, *simulation.space, *simulation.unknowns, bodies, simulation.processes.get(), nodes));
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
  other.scene.sliding = given.sliding;
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

}  // namespace upbead
