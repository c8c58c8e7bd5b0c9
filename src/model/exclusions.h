// Which features of a scene exclude which ways to solve or run it: the only table of them.
#pragma once

#include <string>
#include <vector>

#include "upbead/model/scene.h"

namespace upbead {

/// A way to solve or to run a scene, which not every scene can take.
enum class Treatment {
  reduced_model,
  generalised_alpha,
  adapted_mesh,
  reduce_command,
  soil_model,  ///< one model for every soil
  several_processes,
  checkpoints,
  contact,        ///< node by node
  consolidation,  ///< time.inertia = false
};

/// Why a scene cannot take a way: the key of the scene that asks for something the way does not do.
struct Exclusion {
  std::string key;
  std::string why;   ///< "no fields are written"
  std::string cure;  ///< "" where it is clear to whoever asked for the way
};

/// All reasons, in the order of the table; empty where the scene can take the way.
std::vector<Exclusion> excluded(const Scene& scene, Treatment way);

/// The table in Markdown: the features of a scene, and why each way excludes them.
std::string exclusion_table();

}  // namespace upbead
