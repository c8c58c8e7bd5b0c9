// With which forces the caisson stands on its ground before the waves.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// N_i at the nodes of the interface (N/m, compression positive), and the ways that led to them.
struct RestForces {
  Vector normal_force;
  Ladder ladder;
};

/// How a caisson was set down nobody knows; the first of these by which every node presses is taken: the static state
/// of caisson and soils under their weight; the caisson set down on soils that have settled under theirs; stresses that
/// are linear over the bottom. Throws NumericsError where none does: see check_at_rest.
RestForces rest_forces(const Simulation& simulation, const Interface& interface);

/// Throws InputError where a caisson that may lift does not stand on its whole bottom before the waves: where its
/// weight in water is not downward, or acts outside the middle third.
void check_at_rest(const Simulation& simulation);

}  // namespace upbead
