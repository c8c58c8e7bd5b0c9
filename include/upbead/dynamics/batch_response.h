// One reading of a reduced model for thousands of waves on one time grid.
#pragma once

#include <Eigen/Core>

#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// K loads in rows, N samples in columns, at t = 0, step, 2 step, ...; straight between samples. A first sample that is
/// not zero is a jump at t = 0.
using WaveSamples = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Answers with the recurrence of all modes, O(N M) a wave; const and safe to share between threads.
class BatchResponse {
 public:
  /// `reading`: index into the model's; `step` in s.
  BatchResponse(const ModalModel& model, int reading, double step);
  /// The reading at the N sample times, at t = 0 after a jump.
  void respond(const Eigen::Ref<const WaveSamples>& loads, Eigen::Ref<Eigen::RowVectorXd> y) const;
};

/// Tells what part of a wave's response comes from beyond the frequency to which a model has been checked.
class BandCheck {
 public:
  /// For waves of n samples; `omega`: rad/s.
  BandCheck(const ModalModel& model, int reading, double step, int n, double omega);
  /// The largest |y| of that part (in the reading's unit), by FFT of the loads, the transfer function beyond omega, and
  /// back; n samples are padded by as many zeros.
  double beyond(const Eigen::Ref<const WaveSamples>& loads) const;
};

}  // namespace upbead
