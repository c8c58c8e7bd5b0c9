// What a run tells besides its numbers: warnings, and what was skipped.
#pragma once

#include "upbead/run/simulation.h"
#include "warnings/scene_watch.h"

namespace upbead {

/// Fills in title, loads, soil, warnings and what was skipped.
void tell(SceneWatch& watch, Run& run);

}  // namespace upbead
