// How far a caisson slips on the soil that it shakes: Coulomb's law on a reduced model of the whole scene.
#pragma once

#include <array>
#include <vector>

#include "upbead/dynamics/batch_response.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/dynamics/slip_model.h"
#include "upbead/dynamics/slip_steps.h"
#include "upbead/sliding/block.h"

namespace upbead {

/// What became of a caisson that rested at s = 0.
struct CoupledSliding {
  Sliding slip;              ///< s over the ground
  double dissipated = 0.;    ///< by friction (J/m)
  double peak_shear = 0.;    ///< F_T of largest magnitude, at samples and changes of phase (N/m)
  double least_normal = 0.;  ///< least N' there; below 0 the caisson would have lifted (N/m)
  double lifted_time = 0.;   ///< for so long (s)
  int n_changes = 0;         ///< of phase
  int n_passed_over = 0;     ///< sample steps whose changes of phase were too many to follow
};

/// At the times of the loads; where they jump, before the jump.
struct CoupledHistory {
  Eigen::RowVectorXd shear;     ///< F_T (N/m)
  Eigen::RowVectorXd normal;    ///< N' (N/m)
  Eigen::RowVectorXd velocity;  ///< s' (m/s)
  Eigen::RowVectorXd slip;      ///< s (m)
  Eigen::MatrixXd wanted;       ///< the readings that the model was asked for
};

/// Slides one model under any number of waves; const and safe to share between threads.
///
/// The caisson sticks while |F_T| <= mu N', slips with F_T = +-mu N' until s' = 0, and where N' would be negative
/// nothing holds it. Every phase is a sum of modes (slip_model.h), exact for loads that are straight between their
/// samples; energy coordinates pass from phase to phase. A change of phase is looked for at the samples and found as a
/// root inside the step, so that it is exact; what comes and goes back within one step goes unseen: take steps of a
/// 20th of the shortest period that matters. Several changes in a step are followed as long as the last one shows.
/// s is the exact integral of s'. Dissipated energy takes F_T as straight between samples: error of order step^2.
class CoupledSlip {
 public:
  /// `step` of the samples (s).
  CoupledSlip(SlipModel model, double step);

  const SlipModel& model() const { return model_; }
  double step() const { return step_; }

  /// From rest. Loads in rows, the last of them N_0, as in SlipPhase; samples in columns, at t = 0, step, ... A slip
  /// that is under way at the last sample is followed to its stop, under loads that keep their last values. Throws
  /// std::invalid_argument where the loads are not the model's, NumericsError where they never let it stop.
  CoupledSliding slide(const Eigen::Ref<const WaveSamples>& loads, CoupledHistory* history = nullptr) const;
  /// With times of its own, which cost exponentials each, and jumps.
  CoupledSliding slide(const SampledLoads& loads, CoupledHistory* history = nullptr) const;

 private:
  SlipModel model_;
  double step_;
  std::array<SlipSteps, 4> steps_;
};

}  // namespace upbead
