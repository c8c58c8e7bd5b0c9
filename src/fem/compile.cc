#include "fem/compile.h"

#include <algorithm>

#include "fem/caisson/readings.h"
#include "fem/probes.h"
#include "fem/system_scene.h"

namespace upbead {

namespace {

AssemblyShare share_of(const Space& space, const Processes* processes) {
  return processes ? AssemblyShare{own_cells(space, *processes), processes->rank() == 0} : AssemblyShare();
}

Interface interface_of(const std::vector<InterfaceNode>& nodes) {
  Interface interface;
  for (const InterfaceNode& node : nodes) {
    interface.position.push_back(node.position);
    interface.length.push_back(node.length);
  }
  interface.normal_force = Vector::Zero(interface.n_nodes());
  return interface;
}

bool is_deformable(const std::vector<Body>& bodies) {
  return std::none_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.region == caisson_name; });
}

}  // namespace

CompiledScene compile(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
                      const AssemblyShare& share, const std::vector<InterfaceNode>& interface) {
  CompiledScene compiled;
  compiled.bodies = bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int m = 0; m < n_motions; ++m) compiled.body_coordinates.push_back(unknowns.coordinate(b, m));
  compiled.caisson = find_caisson(space);
  System& system = compiled.system;
  system.field = unknowns.field();
  system.blocks = unknowns.blocks();
  system.n_prescribed = unknowns.n_prescribed();
  if (!interface.empty()) system.interface = interface_of(interface);

  std::optional<CaissonForces> forces;
  const std::vector<InterfaceNode> bottom =
      compiled.caisson && scene.base_stress ? interface_nodes(space) : std::vector<InterfaceNode>();
  if (compiled.caisson) forces.emplace(space, unknowns, *compiled.caisson, bottom);
  assemble(scene, space, unknowns, bodies, forces ? &*forces : nullptr, system, share, interface);

  SceneLoads loads =
      compile_loads(scene, space, unknowns, bodies, compiled.caisson, forces ? &forces->ground : nullptr);
  if (compiled.caisson) {
    const double density = scene.regions.at(caisson_name).density.value_or(0.);
    if (is_deformable(bodies)) compiled.caisson_motions = caisson_motions(space, unknowns, *compiled.caisson);
    const auto momentum = momentum_rows(space, unknowns, bodies, compiled.caisson->body, density);
    system.readings = caisson_readings(*compiled.caisson, *forces, momentum,
                                       uplift_rows(space, unknowns, *compiled.caisson), loads, scene.time.inertia);
  }
  if (!bottom.empty())
    for (Reading& reading : base_readings(space, unknowns, bottom, *forces->bottom, loads))
      system.readings.push_back(std::move(reading));
  for (const auto& probe : scene.probes)
    for (Reading& reading : probe_readings(space, unknowns, scene, probe.first))
      system.readings.push_back(std::move(reading));
  if (!interface.empty())
    for (Reading& reading : interface_readings(unknowns, interface)) system.readings.push_back(std::move(reading));
  system.loads = std::move(loads.loads);
  system.frame_damping = std::move(loads.frame_damping);
  system.frame_radiation = std::move(loads.frame_radiation);
  compiled.loads_on_caisson = std::move(loads.on_caisson);
  compiled.load_of = std::move(loads.of);
  return compiled;
}

void take_courses(const Scene& scene, CompiledScene& compiled) {
  for (std::size_t k = 0; k < compiled.load_of.size(); ++k)
    compiled.system.loads[k].history = scene.loads.at(compiled.load_of[k]).history;
}

CompiledScene with_courses(CompiledScene compiled, const Scene& scene) {
  take_courses(scene, compiled);
  return compiled;
}

AssembledScene assemble_scene(const Scene& scene, const Mesh& mesh, const std::vector<bool>& absent,
                              const SoilState& soil, bool with_interface, const Processes* processes) {
  const Scene part = as_scene(system_scene(scene));
  const auto space = std::make_shared<const Space>(mesh, part, absent, soil);
  const std::vector<Body> bodies = rigid_bodies(*space);
  const auto nodes = with_interface ? interface_nodes(*space) : std::vector<InterfaceNode>();
  const auto unknowns = std::make_shared<const Unknowns>(*space, part, bodies, nodes);
  // in its place from the start: Eigen copies a matrix where others move
  const std::shared_ptr<CompiledScene> compiled(
      new CompiledScene(compile(part, *space, *unknowns, bodies, share_of(*space, processes), nodes)));
  take_courses(scene, *compiled);
  return {space, unknowns, compiled};
}

namespace {

/// Cells with a degree of freedom that moves with a slip or an opening, and their neighbours, of which wet faces are.
std::vector<bool> cells_at_interface(const Space& space, const Unknowns& unknowns) {
  const int first = unknowns.size() - unknowns.n_interface();
  const auto moves = [&](dealii::types::global_dof_index dof) {
    const Row& row = unknowns.expansion(dof);
    return std::any_of(row.begin(), row.end(), [first](const auto& entry) { return entry.first >= first; });
  };
  std::vector<bool> at(space.mesh().triangulation.n_active_cells(), false);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const Dofs dofs = dofs_of(cell);
    at[cell->active_cell_index()] = std::any_of(dofs.begin(), dofs.end(), moves);
  }
  std::vector<bool> with_neighbours = at;
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f) || !cell->neighbor(f)->is_active()) continue;
      const unsigned i = cell->active_cell_index(), j = cell->neighbor(f)->active_cell_index();
      if (at[i]) with_neighbours[j] = true;
      if (at[j]) with_neighbours[i] = true;
    }
  return with_neighbours;
}

}  // namespace

CompiledScene compile_bottom(const Scene& scene, const Space& space) {
  const Scene part = as_scene(system_scene(scene));
  const std::vector<Body> bodies = rigid_bodies(space);
  const std::vector<InterfaceNode> nodes = interface_nodes(space);
  const Unknowns unknowns(space, part, bodies, nodes);
  return compile(part, space, unknowns, bodies, {cells_at_interface(space, unknowns), false}, nodes);
}

}  // namespace upbead
