// One reading of a reduced model for thousands of waves on one time grid.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "upbead/dynamics/modal_model.h"

namespace upbead {

namespace detail {
struct ModeTable;
}

/// K loads in rows, N samples in columns, at t = 0, step, 2 step, ...; straight between samples. A first sample that is
/// not zero is a jump at t = 0.
using WaveSamples = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Computes one reading by the recurrence of all modes, O(N M K) for a wave; const and safe to share between threads.
class BatchResponse {
 public:
  /// `reading`: index into the model's; `step` in s.
  BatchResponse(const ModalModel& model, int reading, double step);
  /// The reading at the N sample times, at t = 0 after a jump. Throws std::invalid_argument where `loads` is not K x N
  /// or y not of length N.
  void respond(const Eigen::Ref<const WaveSamples>& loads, Eigen::Ref<Eigen::RowVectorXd> y) const;

 private:
  std::shared_ptr<const detail::ModeTable> modes_;
  Eigen::RowVectorXd direct_;  ///< K: the direct part, which f_n adds to y_n
};

}  // namespace upbead
