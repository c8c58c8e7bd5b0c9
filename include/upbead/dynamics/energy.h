// Where the work of the loads went.
#pragma once

#include <cmath>

namespace upbead {

/// Energy (J/m) at a time of a march: work = kinetic + strain + fluid + lifted + drag + damping + radiated + scheme +
/// friction + plastic, up to round-off. Each term comes from its own formula; none is the remainder of the others. The
/// exception is soil that yields: there `scheme` also holds the difference between the soil's work as summed over the
/// stages and the energies of its law.
struct EnergyAccount {
  double work = 0.;          ///< done by the loads so far, and by moving bases: their reaction on their own velocity
  double kinetic = 0.;       ///< now, of u and W, and of free water (which is x' K x of its phi)
  double strain = 0.;        ///< now, 1/2 x' K x of u; of soil that yields: stored by its law, and by weights that sank
  double fluid = 0.;         ///< now, stored in compressed fluid and raised surfaces: 1/2 x'^T J M x' of phi
  double lifted = 0.;        ///< now, stored where an interface is open: forces at rest times openings
  double drag = 0.;          ///< taken so far by flow through the pores
  double damping = 0.;       ///< taken so far by material damping, relative to a base that moves
  double radiated = 0.;      ///< carried away so far through absorbing sides, relative to an outcrop that moves
  double scheme = 0.;        ///< taken so far by the time scheme; negative where it added energy
  double friction = 0.;      ///< taken so far at an interface, by friction and by nodes that close
  double plastic = 0.;       ///< taken so far by soil that yields, as its law says
  double largest_work = 0.;  ///< largest |work| so far

  /// Stored in the system now.
  double stored() const { return kinetic + strain + fluid + lifted; }
  /// |work - sum of all others| / largest_work; 0 where no work was done.
  double mismatch() const {
    if (largest_work == 0.) return 0.;
    return std::abs(work - stored() - drag - damping - radiated - scheme - friction - plastic) / largest_work;
  }
};

}  // namespace upbead
