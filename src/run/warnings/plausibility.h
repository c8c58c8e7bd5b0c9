// Numbers that no soil, water or caisson has: most often a wrong unit.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Warnings implausible: a modulus, density, permeability or friction outside what is found in nature, with the unit
/// that is probably meant; submerged_weight: W' of [sliding] differs by more than a tenth from the caisson's weight
/// minus the water that it displaces; no_water: [sliding] assumes buoyancy, but the scene gives no still water.
NumberedWarnings plausibility_warnings(const Simulation& simulation);

}  // namespace upbead
