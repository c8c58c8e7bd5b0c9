// Simulations made from other simulations.
#pragma once

#include "fem/compile.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Checks the scene on the given mesh, and decides what the scene leaves open; nothing is assembled. Throws
/// InputError at keys of the scene.
Simulation::Parts resolved_on(const Scene& given, std::shared_ptr<const Mesh> mesh,
                              std::shared_ptr<const Processes> processes = nullptr);

/// Checks the scene on the given mesh, and assembles it, for `processes` undivided: see compile(). Throws InputError
/// at keys of the scene.
Simulation on_mesh(const Scene& given, std::shared_ptr<const Mesh> mesh,
                   std::shared_ptr<const Processes> processes = nullptr, const Simulation* before = nullptr);

/// Assembled anew of parts whose scene is resolved; undivided.
Simulation assembled(Simulation::Parts parts);

/// The same with the System and the room of `before`, where they are those of these parts; else none is returned.
std::optional<Simulation> taken_over(Simulation::Parts parts, const Simulation& before);

/// The same with room for a basis, which lives as long as the simulation and its copies.
Simulation with_room(const Simulation& simulation);

/// The same with other soil on the same cells.
Simulation with_soil(const Simulation& simulation, const SoilState& soil);

/// The same matrices with another scene, which may differ in times, scheme, sliding, limits or output.
Simulation with_given(const Simulation& simulation, const Scene& given);

/// What the scene allows in all. Where the mesh was made for the tolerance, scene.tolerance is the part of it that is
/// left for a reduced model.
inline double whole_tolerance(const Simulation& simulation) {
  return simulation.given().tolerance;
}

/// The same with another system of equations.
Simulation with_system(const Simulation& simulation, std::shared_ptr<const CompiledScene> compiled);

}  // namespace upbead
