// Contact node by node on a reduced model of all that is linear.
#pragma once

#include <string>

#include "dynamics/basis.h"
#include "run/solve.h"

namespace upbead {

/// Whether contact is solved on a reduced ground: where the case asks for time.scheme = "reduced", and asks for nothing
/// that needs the whole states or the account of energies.
bool reduces_ground(const Simulation& simulation);
/// What stands against it, for a case that asks for it; "" where nothing does.
std::string why_ground_is_whole(const Simulation& simulation);

/// Marches contact with nested models of the ground, until S, peak F_T and F_T(t) of two of them agree. The system has
/// an interface with friction and forces at rest. Throws NumericsError where they do not come close enough, or where a
/// model does not balance.
/// `room`: with the basis of the bonded caisson's model, if there is one; may be null.
Solution contact_on_reduced_ground(const Simulation& simulation, const Marching& marching, const BasisRoom* room);

}  // namespace upbead
