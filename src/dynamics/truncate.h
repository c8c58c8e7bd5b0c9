// A reduced model with few of its modes, and the error of its response.
#pragma once

#include <Eigen/Core>

#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// Modes that are left out follow the load without delay: z = -b f/p.
struct TruncatedModel {
  ModalModel model;
  double left_out = 0.;  ///< sum |c b/p^2| of the modes that are left out, see truncation_error()
};

/// The `n` modes of a model with one load and one reading that count most by |c b/p^2|; those with p = 0 always stay.
TruncatedModel truncated(const ModalModel& model, int n);

/// Bound of the truncated model's error at the samples of a load that is straight in between and 0 at first. With w =
/// z + b f/p a mode has w' = p w + (b/p) f'. Integrated by parts, as f' jumps by d_j at t_j, w = (b/p^2) (sum_j d_j
/// exp(p (t - t_j)) - f'), so that |w| is at most 2 |b/p^2| sum |d_j|, as Re p <= 0.
double truncation_error(const TruncatedModel& truncated, const Eigen::Ref<const Eigen::RowVectorXd>& load, double step);

}  // namespace upbead
