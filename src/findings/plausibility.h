// Numbers of breakwaters.
#pragma once

#include <string>

#include "upbead/base/numbered_warning.h"
#include "upbead/model/region.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// About its G (Pa); 0 where it has none.
double stiffness_of(const Region& region);

/// Warnings submerged_weight and no_water of a W' that is given, beside that weight. Needs a caisson.
void judge_weight(const std::string& key, double given, const Simulation& simulation, NumberedWarnings& list);

}  // namespace upbead
