// The answer of every law of stress. A law is an object of its own, independent of regions and finite elements:
//   LawAnswer update(const PlaneStrain& strain, State& state) const
// takes the total strain since the state at rest and the state last committed, and changes that state to the one at
// the given strain. A solver that iterates must call it each time with a copy of the committed state, never with that
// of an iterate: a path of iterates is not real and must dissipate nothing.
#pragma once

#include <array>

#include "upbead/material/elastic_law.h"

namespace upbead {

/// Derivative of (sigma_xx, sigma_yy, sigma_xy) by (eps_xx, eps_yy, gamma_xy) (Pa); symmetric for associated flow.
using Tangent = std::array<std::array<double, 3>, 3>;

struct LawAnswer {
  PlaneStress stress;      ///< Pa
  Tangent tangent{};       ///< at the end of the step, consistent with the update
  double dissipated = 0.;  ///< energy lost since the committed state (J/m3), never negative
};

}  // namespace upbead
