// Marching two bodies that touch, slip and part, node by node.
#pragma once

#include <memory>

#include "upbead/dynamics/scheme.h"

namespace upbead {

/// What a node does, or the whole bottom.
enum class ContactState : char {
  stick,          ///< no slip; T is whatever that takes, |T| <= mu N
  slip_landward,  ///< T = mu N
  slip_seaward,   ///< T = -mu N
  open            ///< apart, or N < 0 where nothing may part: T = 0
};

/// +1, -1 or 0: where it slips.
inline double direction(ContactState contact) {
  return contact == ContactState::slip_landward ? 1. : contact == ContactState::slip_seaward ? -1. : 0.;
}

/// Forces at the nodes of an interface (N/m).
struct InterfaceForces {
  Vector shear;   ///< T_i on the lower body, landward
  Vector normal;  ///< effective N_i, its part at rest included; compression positive
};

/// What a scheme with a contact law found at the interface.
struct ContactReport {
  InterfaceForces forces;  ///< at the end of the last step
  int slip_steps = 0;      ///< steps in which a node slipped
  int open_steps = 0;      ///< steps in which a node was open
  int impacts = 0;         ///< how often a node closed
  int fallbacks = 0;       ///< contact problems that the active set did not solve, but Gauss-Seidel sweeps did
};

/// Scheme for a system with an interface, "contact". At every node, in every stage:
///
///     opening >= 0,  N_i >= 0,  opening N_i = 0
///     |T_i| <= mu N_i,  T_i = mu N_i sgn(slip rate) where the slip rate is not zero
///
/// without regularisation: the slip rate of a node that sticks and the opening of a closed one are exactly zero. Order
/// 4, and the same to the last bit as SDIRK on the glued system, while no node slips or opens; order 2 while some do;
/// order 1 in steps in which a node closes. One factorisation for each step size. Its report is
/// Scheme::contact(). Throws std::invalid_argument where the system has no interface, or is divided among processes;
/// its steps throw NumericsError where no motion obeys the law. `refined`: see SchemeOptions.
std::unique_ptr<Scheme> make_contact_scheme(const System& system, bool account_energy = true, bool refined = false);

}  // namespace upbead
