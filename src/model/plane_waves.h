// Plane waves in a soil by Biot's equations, with drag and material damping.
#pragma once

#include <complex>

#include "upbead/model/region.h"

namespace upbead {

/// Squares of lambda in exp(s t - lambda x) (1/m2): at s = i omega the real part of lambda is the attenuation per
/// metre, and the imaginary part is 2 pi over the wave's length. 0 for a wave that does not exist or has infinite
/// speed.
struct PlaneWaves {
  std::complex<double> shear;
  std::complex<double> fast;  ///< compression of skeleton and water together; the only one without pores
  std::complex<double> slow;  ///< skeleton against water; diffusion of pressure where drag dominates
};

/// At the complex frequency s (1/s) [Biot 1962; Schanz and Cheng 2000, eqs. of the column], with the equations of
/// docs/theory.md transformed: W = -theta (p' + rho_f s^2 u), theta = 1/(a s^2 + b s), and for u, p ~ exp(-lambda x)
///   (E lambda^2 - s^2 rho_1) (theta lambda^2 - 1/Q) = c^2 lambda^2,
///   c = alpha - s^2 rho_f theta, rho_1 = rho (1 + alpha_R/s) - s^2 rho_f^2 theta, E = (lambda + 2 G) (1 + s beta_R);
/// darcy: a = 0, c = alpha, and rho_1 without its last term; drained, and solids: s^2 rho/E. `flow` is not automatic.
PlaneWaves plane_waves(const Material& material, Flow flow, std::complex<double> s);

}  // namespace upbead
