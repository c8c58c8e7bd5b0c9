// Solving a case whose caisson may slip and lift, node by node.
#pragma once

#include "run/solve.h"

namespace upbead {

/// Throws InputError where a caisson that may lift does not stand on its whole bottom before the waves: where its
/// weight in water is not downward, or acts outside the middle third.
void check_at_rest(const Simulation& simulation);

/// Solves the scene bonded first, from which S by other measures is found. Where no node reaches its friction or is in
/// tension, that is the result; else the scene is marched with the law of contact. The system must have an interface;
/// the simulation of the solution is the one that was solved last. Throws NumericsError.
Solution run_contact(const Simulation& simulation, const Marching& marching);

}  // namespace upbead
