// A scene's own response at a few complex frequencies: cheap, and enough to tell two scenes apart.
#pragma once

#include <complex>
#include <vector>

#include "fem/compile.h"

namespace upbead {

/// Laplace transforms at some s_j.
struct Spectrum {
  std::vector<std::complex<double>> s;      ///< 1/s
  std::vector<std::complex<double>> shear;  ///< of F_T (N s/m)
  Eigen::MatrixXcd X;                       ///< of x, by column, one row per unknown
  Eigen::MatrixXcd F;                       ///< of the loads, by column
};

/// At given s, by a small Krylov space: one factorisation and about 20 solves a load. Needs a caisson and inertia.
/// Throws NumericsError as SecondOrderKrylov does.
Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, const std::vector<std::complex<double>>& s);

/// At s_j = (2 + i pi j) / T, whose inverse holds from the start of the loads to `until` (s): T is the duration of the
/// shortest load, or 1.2 `until` where that is longer; 10 to 80 of them, as far up as the load goes.
Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, double until);

/// F_T(t) (N/m) of a transform at those frequencies: good for the differences of two, at times up to a few durations.
double shear_at(const std::vector<std::complex<double>>& s, const std::vector<std::complex<double>>& shear,
                double time);

/// A reading of x at X, X' = s X, X'' = s^2 X under loads F.
std::complex<double> evaluate(const Reading& reading, const Eigen::VectorXcd& X, std::complex<double> s,
                              const Eigen::VectorXcd& F);

}  // namespace upbead
