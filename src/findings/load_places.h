// Where the loads of a scene act: on the caisson, elsewhere, or on nothing that can give way.
#pragma once

#include "upbead/response/findings.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Whether some load acts on the sea or on the ground and not on the caisson, or moves a boundary, and those on the
/// caisson are a trifle beside F_T: then these are not all that presses it.
bool acts_elsewhere(const Simulation& simulation, const ShearResponse& response);

/// Whether some load still changes after the run, by more than a twentieth of its largest value until then, as one that
/// swings for ever does.
bool loads_go_on(const Simulation& simulation);

/// Warnings load_zero: a load presses on what is held alone; uplift_left_out: a prescribed uplift follows the force on
/// the caisson, and no load presses on that.
NumberedWarnings load_place_warnings(const Simulation& simulation);

}  // namespace upbead
