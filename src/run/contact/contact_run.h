// Solving a case whose caisson may slip and lift, node by node.
#pragma once

#include "run/contact/contact_room.h"
#include "run/sliding/uplift.h"
#include "run/solve.h"

namespace upbead {

/// Throws InputError where a caisson that may lift does not stand on its whole bottom before the waves: where its
/// weight in water is not downward, or acts outside the middle third.
void check_at_rest(const Simulation& simulation);

/// A scene solved bonded, by which contact begins.
struct BondedContact {
  std::shared_ptr<CompiledScene> sliding;  ///< with friction and forces at rest
  std::shared_ptr<ContactRoom> room;
  std::shared_ptr<CompiledScene> tied;  ///< the last readings are the forces at the nodes
  Ladder at_rest;                       ///< ways to the forces at rest, where there are several
  std::vector<UpliftLoad> uplift;
  Solution solution;
  double margin = 0.;  ///< by which these forces may be wrong, over their largest
};
BondedContact solve_bonded(const Simulation& simulation, const Marching& marching);
/// Solves the scene bonded first, from which S by other measures is found. Where no node reaches its friction or is in
/// tension, that is the result; else the scene is marched with the law of contact. The system must have an interface;
/// the simulation of the solution is the one that was solved last. Throws NumericsError.
Solution run_contact(const Simulation& simulation, const Marching& marching);

}  // namespace upbead
