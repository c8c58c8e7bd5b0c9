// Marching two bodies that touch, slip and part, node by node.
#pragma once

#include <memory>

#include "dynamics/ground_matrices.h"
#include "upbead/dynamics/scheme.h"

namespace upbead {

namespace detail {
struct GroundStages;
}

/// State of a node, or of the whole bottom.
enum class ContactState : char {
  stick,          ///< no slip; T is the force that prevents it, |T| <= mu N
  slip_landward,  ///< T = mu N
  slip_seaward,   ///< T = -mu N
  open            ///< separated, or N < 0 in a model without opening: T = 0
};

/// Direction of slip: +1, -1 or 0.
inline double direction(ContactState contact) {
  return contact == ContactState::slip_landward ? 1. : contact == ContactState::slip_seaward ? -1. : 0.;
}

/// Forces at the nodes of an interface (N/m).
struct InterfaceForces {
  Vector shear;   ///< T_i on the lower body, landward
  Vector normal;  ///< effective N_i, its part at rest included; compression positive
};

/// Results of a scheme with a contact law.
struct ContactReport {
  InterfaceForces forces;  ///< at the end of the last step
  Vector gap{};            ///< then: forces of the water that entered gaps, beyond those of loads; empty: none did
  int slip_steps = 0;      ///< steps in which a node slipped
  int open_steps = 0;      ///< steps in which a node was open
  int impacts = 0;         ///< how often a node closed
  int fallbacks = 0;       ///< contact problems in which the active set failed and Gauss-Seidel sweeps helped
};

/// Scheme for a system with an interface, "contact". At every node, in every stage:
///
///     opening >= 0,  N_i >= 0,  opening N_i = 0
///     |T_i| <= mu N_i,  T_i = mu N_i sgn(slip rate) where the slip rate is not zero
///
/// without regularisation: the slip rate of a node that sticks and the opening of a closed one are exactly zero.
/// Order 4, and the same to the last bit as SDIRK on the bonded system, while no node slips or opens; order 2 while
/// some do; order 1 in steps in which a node closes. One factorisation for each step size. Its report is
/// Scheme::contact(). Throws std::invalid_argument where the system has no interface; its steps throw NumericsError
/// where no motion obeys the law. `refined`: see SchemeOptions.
std::unique_ptr<Scheme> make_contact_scheme(const System& system, bool account_energy = true, bool refined = false);
/// The same scheme where the matrices are those of a ground of few coordinates, which must outlive it; those of the
/// system are not read. Its account of energy does not tell fields apart: `kinetic` is all that M holds, `strain` all
/// that K holds, `damping` all that C takes. `stages`: what marches on that ground have inverted (ground_steps.h), for
/// the next one, which is the same to the last bit; null: nothing is kept.
std::unique_ptr<Scheme> make_contact_scheme(const System& system, const GroundMatrices& ground,
                                            std::shared_ptr<detail::GroundStages> stages = nullptr);

}  // namespace upbead
