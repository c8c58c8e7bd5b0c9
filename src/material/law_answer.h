// What every law of stress answers. A law is a value of its own, without regions or elements:
//   LawAnswer update(const PlaneStrain& strain, State& state) const
// takes the whole strain since the state at rest and the state that was last committed, and leaves the state that
// belongs to that strain. Whoever iterates calls it with a copy of the committed state each time, never with that of an
// iterate: what a path of iterates would dissipate has not happened.
#pragma once

#include <array>

#include "upbead/material/elastic_law.h"

namespace upbead {

/// (sigma_xx, sigma_yy, sigma_xy) by (eps_xx, eps_yy, gamma_xy) (Pa); symmetric where the flow is associated.
using Tangent = std::array<std::array<double, 3>, 3>;

struct LawAnswer {
  PlaneStress stress;      ///< Pa
  Tangent tangent{};       ///< of the stress at the end, consistent with the update
  double dissipated = 0.;  ///< since the committed state (J/m3), never negative
};

}  // namespace upbead
