// Readings at points: everything that can be measured there.
#pragma once

#include <string>
#include <vector>

#include "fem/unknowns.h"

namespace upbead {

/// Displacement, velocity and acceleration; where there is pore water, pressure, and with inertial flow Darcy velocity;
/// where there is an elastic skeleton or solid, strain and effective stress (tension positive; without the viscous part
/// of the damping). Their group is "probes".
std::vector<Reading> probe_readings(const Space& space, const Unknowns& unknowns, const Scene& scene,
                                    const std::string& name);

}  // namespace upbead
