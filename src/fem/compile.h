// Compiles a scene: Scene on a mesh -> System. No other code knows both.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fem/assembly.h"
#include "fem/caisson/caisson.h"
#include "fem/scene_loads.h"
#include "fem/space.h"
#include "fem/unknowns.h"
#include "upbead/model/scene.h"
#include "upbead/system/system.h"

namespace upbead {

struct CompiledScene {
  System system;
  std::vector<Body> bodies;
  std::vector<int> body_coordinates;  ///< unknowns of the system that are coordinates of rigid bodies
  std::optional<Caisson> caisson;
  /// The rigid-body motions of a caisson that deforms, as vectors of unknowns: a projection on a space with these
  /// keeps the balance of forces on the caisson. Empty where the caisson's coordinates are unknowns.
  std::vector<Vector> caisson_motions;
  std::vector<LoadOnCaisson> loads_on_caisson;  ///< one per system load
  std::vector<std::string> load_of;             ///< per system load: the name of the scene's load
};

/// Assembles M, C, K, the loads and all readings. The scene must have passed check_scene on this mesh. `share`: of
/// what the matrices are; where that is not all cells, the system must still be divided. With the nodes of an
/// interface, which `unknowns` must have been made with, the system has that interface, without friction or forces at
/// rest.
CompiledScene compile(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
                      const AssemblyShare& share = {}, const std::vector<InterfaceNode>& interface = {});

/// Gives the loads the course that they have in a scene which differs in nothing else of system_scene.h.
void take_courses(const Scene& scene, CompiledScene& compiled);
CompiledScene with_courses(CompiledScene compiled, const Scene& scene);

/// The system of a scene and the data that its equations need; copies share the data.
struct AssembledScene {
  std::shared_ptr<const Space> space;
  std::shared_ptr<const Unknowns> unknowns;
  std::shared_ptr<const CompiledScene> compiled;
};

/// A resolved scene compiled on its mesh; `with_interface`: the caisson may slip and lift. What is assembled is made of
/// system_scene(scene) alone.
AssembledScene assemble_scene(const Scene& scene, const Mesh& mesh, const std::vector<bool>& absent,
                              const SoilState& soil, bool with_interface, const Processes* processes = nullptr);

/// The scene of that space with its interface, made of the cells at the caisson's bottom alone: the rows of slips and
/// openings are whole, and so are readings; other rows hold what these cells add. Its free unknowns are those of the
/// scene without an interface, whose System has all that is missing here.
CompiledScene compile_bottom(const Scene& scene, const Space& space);

}  // namespace upbead
