// Whether cells and steps carry the waves of loads on the ground to where they are read.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Warning stress_rings: a load acts on ground that deforms, and the error of its waves at a probe there, or in the
/// fields, due to cells and steps (response/carried_pulse.h) is more than 5 %. The worst of all loads and regions.
NumberedWarnings ring_warnings(const Simulation& simulation);

/// Warning slow_wave_unresolved: the same for the wave of the pore water against the skeleton where flow is inertial.
/// It is carried by the pressures, of a degree less than displacements.
NumberedWarnings slow_wave_warnings(const Simulation& simulation);

}  // namespace upbead
