// Many readings of a reduced model at a few times of a wave.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dynamics/batch_response.h"
#include "dynamics/lanes.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead {

/// All readings of a model at a few sample times of waves with one step: the modes are advanced through all samples,
/// the readings are formed at those times alone. Const and safe to share between threads.
class ReadingsAt {
 public:
  /// `step` in s.
  ReadingsAt(const ModalModel& model, double step);
  /// A row for each reading, a column for each of the ascending indices of samples. Loads as for BatchResponse. Throws
  /// std::invalid_argument where the loads do not fit the model, or an index is beyond them.
  Eigen::MatrixXd of(const Eigen::Ref<const WaveSamples>& loads, const std::vector<std::size_t>& times) const;

 private:
  double step_;
  Eigen::Index n_modes_;
  detail::SplitArray E_, start_;
  std::vector<Eigen::MatrixXd> reading_;  ///< for each load: of Re and Im of w, by which modes take the load up
  Eigen::MatrixXd direct_, impulse_;      ///< readings x loads: what f_n adds, and its integral
};

/// The same for loads at any times: columns of respond() at those indices.
Eigen::MatrixXd respond_at(const ModalModel& model, const SampledLoads& loads, const std::vector<std::size_t>& times);

}  // namespace upbead
