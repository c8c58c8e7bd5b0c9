// The response of a reduced model to a wave: without time steps, exact for loads that are linear between their samples.
#pragma once

#include <vector>

#include "upbead/dynamics/march.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// K loads, linear between N + 1 ascending times (s), the first of which is 0. A load may jump at a time: then end(k, n
/// - 1) differs from begin(k, n).
struct SampledLoads {
  std::vector<double> time;
  Eigen::MatrixXd begin;  ///< K x N: f_k at time[n] from the right
  Eigen::MatrixXd end;    ///< K x N: f_k at time[n + 1] from the left
};

/// Samples of the functions at those times.
SampledLoads sample(const std::vector<TimeFunction>& loads, const std::vector<double>& time);

/// All readings at the times of the loads, from rest at t = 0, by the exact recurrence of every mode. Where a load
/// jumps, a reading belongs to the load's value before the jump; at t = 0, to no load. The times need not be equally
/// spaced.
Series respond(const ModalModel& model, const SampledLoads& loads);

}  // namespace upbead
