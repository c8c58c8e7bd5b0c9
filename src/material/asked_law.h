// Soil whose stress is asked of a function of Python, for tries of a law: upbead.StressLaw there. Slow: each evaluation
// of the internal force is a message there and back.
#pragma once

#include "material/soil_law.h"

namespace upbead {

extern const SoilLawRow asked_row;

/// Whether somebody answers, at the socket that the environment names: $UPBEAD_STRESS_LAWS.
bool laws_are_answered();

}  // namespace upbead
