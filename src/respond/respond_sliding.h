// S of one wave that a reduced model has answered.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "upbead/output/model_file.h"

namespace upbead {

/// U(t) >= 0 that follows P(t), given at ascending times (s), as the case has it; for shapes in_phase and held.
Eigen::RowVectorXd uplift_of_force(const ModelSliding& sliding, const std::vector<double>& time,
                                   const Eigen::RowVectorXd& P);

/// S (m) by eq. (4): F_T and U straight between the times; an empty U is none. mass: W/g (kg/m).
double sliding_distance(const ModelSliding& sliding, double mass, const std::vector<double>& time,
                        const Eigen::RowVectorXd& F_T, const Eigen::RowVectorXd& U);

}  // namespace upbead
