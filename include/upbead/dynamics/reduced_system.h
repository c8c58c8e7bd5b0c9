// A System in a few coordinates.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// M q'' + C q' + K q = sum_k load_k f_k(t) for R coordinates, with readings y = position q + velocity q' +
/// acceleration q'' + feedthrough f. It is symmetric as the System is. With the rows of phi multiplied by -1, M >= 0,
/// sym(C) >= 0 and K >= 0, because displacements and phi are each projected on vectors of their own.
///
/// The first n_prescribed coordinates are the prescribed unknowns: q'_p = f_k replaces their rows, which are no
/// equations.
struct ReducedSystem {
  Eigen::MatrixXd M, C, K;                           ///< R x R
  Eigen::MatrixXd load;                              ///< R x K
  std::vector<int> prescribed;                       ///< by load: the coordinate that it prescribes, or -1
  Eigen::MatrixXd position, velocity, acceleration;  ///< I x R
  Eigen::MatrixXd feedthrough;                       ///< I x K
  std::vector<bool> is_phi;                          ///< R
  int n_prescribed = 0;
  double shift = 0.;  ///< s_0 of its Krylov space (1/s)
  std::vector<std::string> load_name;
  std::vector<ReadingLabel> reading_label;

  int size() const { return static_cast<int>(is_phi.size()); }
};

}  // namespace upbead
