// How much of an answer rests on frequencies at which nobody has checked the model.
#pragma once

#include <memory>

#include "dynamics/batch_response.h"

namespace upbead {

namespace detail {
class RealFft;
}

/// Tells what part of a wave's response comes from beyond the frequency to which a model has been checked. The wave is
/// straight between its samples; what these lines hold beyond the samples' own band counts. Const and safe to share
/// between threads.
class BandCheck {
 public:
  /// For waves of n samples, `step` (s) apart; `omega`: rad/s.
  BandCheck(const ModalModel& model, int reading, double step, int n, double omega);
  /// The largest |y| of that part (in the reading's unit) at the samples' times, by FFT of the loads, the transfer
  /// function beyond omega, and back; n samples are padded by at least as many zeros. Throws std::invalid_argument
  /// where `loads` is not K x n.
  double beyond(const Eigen::Ref<const WaveSamples>& loads) const;

 private:
  int n_;
  std::shared_ptr<const detail::RealFft> fft_;
  Eigen::MatrixXcd transfer_;  ///< frequencies of the FFT x K
};

}  // namespace upbead
