// The section of a scene's mesh: its soils between lines, for figures of rupture.
#pragma once

#include "rupture/section.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Soils are the porous and solid regions but for the caisson; those without a strength may not fail. Rigid regions and
/// water are no soil. Weights as at rest (fem/ground.h), submerged below still water.
GroundSection ground_section(const Simulation& simulation);

}  // namespace upbead
