// Whether what lies at the upper and lower borders of a section with a caisson is what nature has there.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Warnings of outer curves that face down: base_free, ground that nothing bears; and up: sea_sealed, a lid on the sea;
/// ground_sealed, one on the pores of ground under water; ground_held, ground whose surface cannot move.
NumberedWarnings border_warnings(const Simulation& simulation);

}  // namespace upbead
