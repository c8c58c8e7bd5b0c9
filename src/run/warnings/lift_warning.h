// Whether a caisson that is tied to its ground pulls at it.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// would_lift: an edge of a tied caisson pulls, its effective stress N'/B - 6 |M'|/(1.26 B^2). N' = W' + change of the
/// normal force - U, M' = W' e + base moment + moment of U, U the modelled pore pressure's and e how far W' acts
/// landward of the bottom's middle. W' is that of [sliding], less a prescribed uplift, or the mass less the water that
/// the caisson displaces below still water; without either there is no warning.
NumberedWarnings lift_warnings(const Simulation& simulation, const Run& run);

}  // namespace upbead
