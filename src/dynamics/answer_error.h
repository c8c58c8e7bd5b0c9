// How wrong a reduced model's answer to a wave is: beside larger models, and beyond the frequencies that were checked.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "dynamics/batch_response.h"
#include "upbead/dynamics/nested_models.h"

namespace upbead {

namespace detail {
class RealFft;
}

/// By how much larger models answer a wave differently: on its own spectrum, and for as long as it is asked for.
struct ResponseDifference {
  Eigen::VectorXd of_model;   ///< reference less model, at the samples
  Eigen::VectorXd of_middle;  ///< reference less middle model

  /// An upper bound of the model's largest error, measured on scenes that it was not made for: docs/reduced.md.
  double bound() const;
};

/// The differences for waves of n samples, `step` (s) apart, straight in between and zero before and after. Const and
/// safe to share between threads.
///
/// By FFT at Z = exp((sigma + i omega) step), where each mode's recurrence z' = E z + h (phi_1 - phi_2) b f_n +
/// h phi_2 b f_(n+1) is h b (phi_1 + (Z - 1) phi_2) / (Z - E): exact at the samples, as lines are. The weight
/// exp(-sigma t), with sigma = 10 over the padded length, keeps undamped poles off the contour and what wraps around
/// below exp(-10) of itself.
class ResponseError {
 public:
  /// `reading`: index into the model's; that of the nested models is their only one. `n_waves`: that will be asked
  /// about; few are answered by the recurrences of all three models instead, which takes longer for each and no time
  /// before.
  ResponseError(const ModalModel& model, int reading, const NestedModels& nested, double step, int n, int n_waves);
  /// Throws std::invalid_argument where `loads` is not K x n.
  ResponseDifference of(const Eigen::Ref<const WaveSamples>& loads) const;

 private:
  struct ByFft;
  int n_loads_, n_;
  std::shared_ptr<const ByFft> by_fft_;  ///< of many waves
  std::vector<BatchResponse> models_;    ///< of few: the model, middle, reference
};

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
