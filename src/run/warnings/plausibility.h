// Numbers that no soil, water or caisson has: most often a unit that was meant otherwise.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// implausible: a modulus, density, permeability or friction outside what is found in nature, with the unit that is
/// probably meant. submerged_weight: W' of [sliding] is not the caisson's weight less the water that it displaces by
/// more than a tenth. no_water: [sliding] counts on buoyancy, but the scene tells no still water.
NumberedWarnings plausibility_warnings(const Simulation& simulation);

}  // namespace upbead
