// What the pressure of pore water does to the skeleton of the ground.
#pragma once

#include "fem/ground.h"

namespace upbead {

/// Nodal forces of an excess pore pressure p on the effective stress of the ground:
///   integral of p div v over the pores - integral of p n . v over where the ground ends: at free water, outside, and
///   at the caisson,
/// as total stress is effective stress less p (theory.md), and the same p presses there from outside. `pressure`: at
/// the degrees of freedom of phi of `pores`, a space on the same mesh.
Vector pore_forces(const Ground& ground, const Space& pores, const Vector& pressure);

}  // namespace upbead
