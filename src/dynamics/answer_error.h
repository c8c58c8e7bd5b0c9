// Errors of a reduced model's response to a wave: against larger models, and beyond the frequencies that were
// checked.
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

/// The differences between larger models and a model in their response to a wave: on the wave's own spectrum, and
/// over its own duration.
struct ResponseDifference {
  Eigen::VectorXd of_model;   ///< reference minus model, at the samples
  Eigen::VectorXd of_middle;  ///< reference minus middle model
  double safety;              ///< see NestedModels::safety

  /// An upper bound of the model's largest error. Its factors were tested on scenes that did not set them:
  /// docs/reduced.md.
  double bound() const;
};

/// The differences for waves of n samples, `step` (s) apart, straight in between and zero before and after. Const and
/// safe to share between threads.
///
/// By FFT at Z = exp((sigma + i omega) step), where each mode's recurrence z' = E z + h (phi_1 - phi_2) b f_n + h
/// phi_2 b f_(n+1) is h b (phi_1 + (Z - 1) phi_2) / (Z - E): exact at the samples, as loads are straight in between.
/// The weight exp(-sigma t), with sigma = 10 over the padded length, keeps undamped poles off the contour and damps
/// parts that wrap around by exp(-10).
class ResponseError {
 public:
  /// `reading`: index into the model's readings; the nested models have this one only. `n_waves`: number of waves to
  /// be checked; few are answered by the recurrences of all three models, which takes longer for each wave but needs
  /// no preparation.
  ResponseError(const ModalModel& model, int reading, const NestedModels& nested, double step, int n, int n_waves);
  /// Throws std::invalid_argument where `loads` is not K x n.
  ResponseDifference of(const Eigen::Ref<const WaveSamples>& loads) const;

 private:
  struct ByFft;
  int n_loads_, n_;
  double safety_;
  std::shared_ptr<const ByFft> by_fft_;  ///< for many waves
  std::vector<BatchResponse> models_;    ///< for few waves: model, middle, reference
};

/// Finds the part of a wave's response that comes from beyond the frequency up to which a model has been checked. The
/// wave is straight between its samples; frequencies that these lines contain above the samples' own band count, too.
/// Const and safe to share between threads.
class BandCheck {
 public:
  /// For waves of n samples, `step` (s) apart; `omega`: rad/s.
  BandCheck(const ModalModel& model, int reading, double step, int n, double omega);
  /// The largest |y| of that part (in the reading's unit) at the times of the samples: FFT of the loads, times the
  /// transfer function beyond omega, and inverse FFT; n samples are padded by at least as many zeros. Throws
  /// std::invalid_argument where `loads` is not K x n.
  double beyond(const Eigen::Ref<const WaveSamples>& loads) const;

 private:
  int n_;
  std::shared_ptr<const detail::RealFft> fft_;
  Eigen::MatrixXcd transfer_;  ///< frequencies of the FFT x K
};

}  // namespace upbead
