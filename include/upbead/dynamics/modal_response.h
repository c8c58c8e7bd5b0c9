// What a reduced model answers to a wave: exact for loads that are straight between their samples, no time steps.
#pragma once

#include <vector>

#include "upbead/dynamics/march.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// K loads, straight lines between ascending times (s), of which there are N + 1, the first of them 0. They may jump at
/// a time: then end(k, n - 1) differs from begin(k, n).
struct SampledLoads {
  std::vector<double> time;
  Eigen::MatrixXd begin;  ///< K x N: f_k at time[n] from the right
  Eigen::MatrixXd end;    ///< K x N: f_k at time[n + 1] from the left
};

/// Samples of the functions at those times.
SampledLoads sample(const std::vector<TimeFunction>& loads, const std::vector<double>& time);

/// All readings at the times of the loads, from rest at t = 0, by the exact recurrence of every mode; where a load
/// jumps, of the value before the jump, and at t = 0 of no load. The steps may all differ.
Series respond(const ModalModel& model, const SampledLoads& loads);

}  // namespace upbead
