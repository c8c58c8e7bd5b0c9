// The stiffness of a rigid strip bonded to elastic soil, without finite elements.
#pragma once

#include <Eigen/Core>

#include "layer_flexibility.h"

namespace upbead::test {

/// Forces per displacement of the strip's middle: rows and columns sway (x), heave, rotation, as for the program's
/// rigid bodies; e^{+i a0 t}.
using Stiffness = Eigen::Matrix3cd;

/// K(a0) by Galerkin's method: contact tractions sum c_n T_n(x) / (pi sqrt(1 - x^2)), whose transforms are Bessel
/// functions, on the exact flexibility of the soil. 12 and 24 terms, extrapolated by n^-2; the frequency has damping
/// of 1e-4, 2e-4 and 3e-4, extrapolated to zero. Errors are about 1e-5 away from a layer's resonances.
Stiffness theoretical_stiffness(const ElasticSoil& soil, double a0);

}  // namespace upbead::test
