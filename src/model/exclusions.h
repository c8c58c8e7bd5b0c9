// What cannot go with what: the one table.
#pragma once

#include <string>
#include <vector>

#include "upbead/model/scene.h"

namespace upbead {

/// A way to solve or to run a scene that not every scene can take.
enum class Treatment {
  reduced_model,
  generalised_alpha,
  adapted_mesh,
  reduce_command,
  several_processes,
  checkpoints,
  contact,        ///< node by node
  consolidation,  ///< time.inertia = false
};

/// Why a scene cannot take a way: at a key of the scene, which asks for what the way does not do.
struct Exclusion {
  std::string key;
  std::string why;   ///< "no fields are written"
  std::string cure;  ///< "" where whoever asked for the way knows it
};

/// All reasons, by the order of the table; empty where the scene can take it.
std::vector<Exclusion> excluded(const Scene& scene, Treatment way);

/// The table in Markdown: what a scene asks for, and why each way cannot do it.
std::string exclusion_table();

}  // namespace upbead
