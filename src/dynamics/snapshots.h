// Where a System's response goes: its state at complex frequencies, as directions of a basis for it and others alike.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/dynamics/reduced_system.h"

namespace upbead {

/// By column, for both kinds of unknowns, in the order of FieldBasis::unknown; not in its units.
struct Snapshots {
  Eigen::MatrixXd displacements, phi;
  ReducedSystem own;  ///< the System in its own Krylov space: its first coordinates are those that are kept
};

/// How a System's response is found.
struct SnapshotOptions {
  double shift = 0.;       ///< of the Krylov space (1/s)
  std::vector<int> exact;  ///< see SecondOrderKrylov
  int vectors = 60;        ///< per independent load
  std::vector<std::complex<double>> frequencies;
  Eigen::MatrixXd weights;                 ///< of each load (row) at each frequency (column)
  int n_readings = 0;                      ///< so many of the last loads stand for readings, see snapshots()
  std::function<void(double)> progress{};  ///< 0 to 1; may be empty
};

/// Real and imaginary parts of X(s_j) under each load alone, times its weight; all together have length 1 in the units
/// of the Krylov space. What answers the row of a reading as a load is where another soil changes that reading, as the
/// equations are symmetric (the dual problem: Pierce and Giles 2000): each such load has a tenth of the length of all
/// others. Costs one factorisation, and a solve per vector. Throws as SecondOrderKrylov does.
Snapshots snapshots(const System& system, const SnapshotOptions& options);

/// s_j = 3/T + i omega_j from 0 to `highest` (rad/s), as close as the real part resolves, but at most `most`; T is the
/// end of the loads (s).
std::vector<std::complex<double>> snapshot_frequencies(double end, double highest, int most);

/// The weights of loads: |F_k(s)|, or a tenth of its bound min(int |f|, V/|s|^2), V the variation of f', where |F_k|
/// is smaller: other waves of that length have no zeros there.
Eigen::MatrixXd snapshot_weights(const SampledLoads& loads, const std::vector<std::complex<double>>& frequencies);

}  // namespace upbead
