// A scene's own response at a few complex frequencies: cheap, and enough to compare two scenes, and to find the cells
// that make F_T wrong.
#pragma once

#include <complex>
#include <vector>

#include "fem/compile.h"

namespace upbead {

class BasisRoom;

/// Laplace transforms at some s_j.
struct Spectrum {
  std::vector<std::complex<double>> s;      ///< 1/s
  std::vector<std::complex<double>> shear;  ///< of F_T (N s/m)
  Eigen::MatrixXcd X;                       ///< of x, by column, one row per unknown
  Eigen::MatrixXcd F;                       ///< of the loads, by column
};

/// At given s, by a small Krylov space: one factorisation and about 20 solves for each load. Needs a caisson and
/// inertia. `room`: empty, for the basis of a reduction that goes on with it; null: none is kept. Throws NumericsError
/// as SecondOrderKrylov does.
Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, const std::vector<std::complex<double>>& s,
                        BasisRoom* room = nullptr);

/// At s_j = (2 + i pi j) / T, from which the inverse transform is valid from the start of the loads to `until` (s): T
/// is the duration of the shortest load, or 1.2 `until` where that is longer; 10 to 80 frequencies, as high as the
/// load has content.
Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, double until);

/// F_T(t) (N/m) from a transform at those frequencies: accurate for the difference of two transforms, at times up to
/// a few durations.
double shear_at(const std::vector<std::complex<double>>& s, const std::vector<std::complex<double>>& shear,
                double time);

/// Contributions of the cells to the error of F_T, relative to its size: good to compare cells, not to find the size
/// of the error.
struct MeshError {
  std::vector<double> of_cell;  ///< by active cell index
  double sum = 0.;              ///< sum of absolute errors of all cells
};

/// For the scene's own loads, at frequencies from one half-wave in the run to four in the shortest load, each
/// weighted with its share in F_T. As the equations are symmetric, the error of the work F x_G of a force F is the
/// square of the error of x in the energy norm (goal and load are one: Becker and Rannacher 2001, sec. 2), and F_T =
/// P - m x_G'' errs with it. Low frequencies show the singular corners of the caisson's bottom, high ones the cells
/// that are too long for the waves. Needs a caisson and inertia. Throws NumericsError as solve_spectrum does.
MeshError mesh_error(const Scene& scene, const Space& space, const Unknowns& unknowns, const CompiledScene& compiled,
                     BasisRoom* room = nullptr);

}  // namespace upbead
