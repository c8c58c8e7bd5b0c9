// How far two histories of F_T lie apart.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem/compile.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// F_T of one solution.
struct ShearHistory {
  std::vector<double> time;  ///< s
  Eigen::RowVectorXd force;  ///< N/m
  double peak = 0.;          ///< that shear_to_force_ratio takes, found inside the steps (N/m)
};

ShearHistory shear_history(const CompiledScene& compiled, const Response& response, bool inertia);

/// Differences of the peaks, over that of `better`, and at all times, over its largest |F_T|; of times that both do not
/// share, linear between them.
ShearError difference(const ShearHistory& answer, const ShearHistory& better);

}  // namespace upbead
