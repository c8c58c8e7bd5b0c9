// Marches of very many steps, and harmonic loads marched to their steady state.
#pragma once

#include <vector>

#include "upbead/dynamics/scheme.h"

namespace upbead::test {

/// Response to a load that is applied suddenly and stays, over very many steps.
struct LongMarch {
  int unknowns = 0;
  double periods = 0.;  ///< length of the march, in periods of the slowest mode that the load excites
  double energy = 0.;   ///< |work - sum of all energies stored and taken| over the largest work, at the end
  double drift = 0.;    ///< difference of the mean displacement of the last tenth from K^-1 f, over that
  double motion = 0.;   ///< largest kinetic energy in the last tenth of the march, over that in the first
  bool finite = false;
};

/// A column of dry sand without any damping, or of sand full of water, under a traction on its top, in `steps` steps.
LongMarch march_long(SchemeKind kind, bool wet, int steps);

/// Errors of a march of damped dry sand under a harmonic load near resonance: in the last of many periods, against
/// the sine of amplitude |X| by the frequency response, over |X|, with 16, 32, 64, ... steps a period.
std::vector<double> steady_state_errors(SchemeKind kind, int halvings);

}  // namespace upbead::test
