// Whether cells and steps carry the waves of loads on the ground to where somebody looks.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// stress_rings: a load acts on ground that deforms, and its cells do not carry its waves to a probe there, or to the
/// fields, as the equations would (response/carried_pulse.h): by more than 5 %. The worst of all loads and regions.
NumberedWarnings ring_warnings(const Simulation& simulation);

/// slow_wave_unresolved: the same of the wave of the pore water against the skeleton where flow is inertial, which
/// pressures carry, of a degree less than displacements.
NumberedWarnings slow_wave_warnings(const Simulation& simulation);

}  // namespace upbead
