// Plane waves of a soil as Biot's equations have them, with drag and material damping.
#pragma once

#include <complex>

#include "upbead/model/region.h"

namespace upbead {

/// Squares of lambda in exp(s t - lambda x) (1/m2): at s = i omega the real part of lambda tells how a wave is
/// attenuated, the imaginary part is 2 pi over its length. 0 of a wave that there is not, or that has infinite speed.
struct PlaneWaves {
  std::complex<double> shear;
  std::complex<double> fast;  ///< compression of skeleton and water together; of what has no pores the only one
  std::complex<double> slow;  ///< skeleton against water; diffusion of pressure where drag rules
};

/// At the complex frequency s (1/s) [Biot 1962; Schanz and Cheng 2000, eqs. of the column], with the equations of
/// docs/theory.md transformed: W = -theta (p' + rho_f s^2 u), theta = 1/(a s^2 + b s), and for u, p ~ exp(-lambda x)
///   (E lambda^2 - s^2 rho_1) (theta lambda^2 - 1/Q) = c^2 lambda^2,
///   c = alpha - s^2 rho_f theta, rho_1 = rho (1 + alpha_R/s) - s^2 rho_f^2 theta, E = (lambda + 2 G) (1 + s beta_R);
/// darcy: a = 0 and c = alpha, rho_1 without the last part; drained, and of solids: s^2 rho/E. `flow` decided.
PlaneWaves plane_waves(const Material& material, Flow flow, std::complex<double> s);

}  // namespace upbead
