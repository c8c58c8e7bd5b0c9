// The loads of a scene as right-hand sides of the system, and their resultants on the caisson.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fem/caisson/caisson.h"
#include "fem/unknowns.h"
#include "upbead/fem/load_on_caisson.h"
#include "upbead/system/system.h"

namespace upbead {

/// All loads; entry i of each list belongs to load i.
struct SceneLoads {
  std::vector<SystemLoad> loads;
  std::vector<std::string> of;  ///< the name of the scene's load
  std::vector<LoadOnCaisson> on_caisson;
  /// Forces on the ground's cells; at nodes shared with the caisson they count for the ground, not for P.
  std::vector<NodalForces> on_ground;
  FrameDashpots frame_damping, frame_radiation;  ///< see System
};

/// One system load for each load of the scene whose factor is not 0, and one more if that load prescribes a pore
/// pressure. `ground` is needed where there is a caisson.
SceneLoads compile_loads(const Scene& scene, const Space& space, const Unknowns& unknowns,
                         const std::vector<Body>& bodies, const std::optional<Caisson>& caisson,
                         const NodalReaction* ground);

/// The pressure that a load on a wall of the caisson has at the wall's lower end `foot`, at f(t) = 1 (Pa); 0 where it
/// acts elsewhere.
double pressure_at_foot(const Space& space, const Load& load, const dealii::Point<dim>& foot);

}  // namespace upbead
