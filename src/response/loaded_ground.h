// Ground that loads act on directly, and who looks at the waves in it.
#pragma once

#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// A load on a side of ground that deforms, and a region in which somebody looks at the waves that it sends out.
struct LoadedGround {
  std::string load;
  std::string region;                   ///< in which a probe stands; with fields any that deforms
  std::string onlooker;                 ///< "probe 'A'", of several the nearest, or "the fields"
  bool pushes = false, shears = false;  ///< whether it acts along the side's mean normal, and along the side
  bool is_plane = false;                ///< its ends are as far apart as the mesh is wide: waves do not spread
  double cell = 0.;                     ///< h, of the largest cell of the region on the way, along the normal (m)
  double nearest = 0., farthest = 0.;   ///< onlookers, from the side (m); with fields from the side to the mesh's end
};

/// All of a scene as solved, with loads that are switched on. A rigid body sends out smoother waves than the loads on
/// it and makes none; nor does free water.
std::vector<LoadedGround> loaded_grounds(const Scene& scene, const Mesh& mesh);

}  // namespace upbead
