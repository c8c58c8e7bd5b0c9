// Sliding of a caisson on soil that it shakes: Coulomb's law on a reduced model of the whole scene.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "dynamics/batch_response.h"
#include "dynamics/slip_model.h"
#include "dynamics/slip_steps.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/sliding/block.h"

namespace upbead {

/// Results for a caisson that rested at s = 0.
struct CoupledSliding {
  Sliding slip;              ///< s over the ground
  double dissipated = 0.;    ///< by friction (J/m)
  double available = 0.;     ///< what friction could take in slips: work of the loads, and stored energy set free (J/m)
  double uncertain = 0.;     ///< largest error of these two integrals (J/m)
  double pressed = 0.;       ///< impulse of N' > 0 while it slips (N s/m)
  double pulled = 0.;        ///< impulse of N' < 0, by which the ground would have to pull (N s/m)
  double peak_shear = 0.;    ///< F_T of largest magnitude, at samples and changes of phase (N/m)
  double least_normal = 0.;  ///< least N' there; below 0 the caisson would have lifted (N/m)
  double lifted_time = 0.;   ///< how long N' was below 0 (s)
  int n_changes = 0;         ///< of phase
  int n_passed_over = 0;     ///< pieces of steps whose changes of phase were too many to follow
};

/// Why S cannot count as a distance, or "": not all changes of phase were followed, a number is not finite, friction
/// takes more energy than there was (`available`, by more than `uncertain`), or the bottom would part from the
/// ground, which pulls at it in this model. Without that pull a share pulled/pressed of the friction, mu times the
/// impulse of N', would be missing; up to 1 % is accepted.
std::string why_no_distance(const CoupledSliding& sliding);
/// The same where damping was added for the numerics alone (SlipModel::damping_time): `more`, with twice as much,
/// must not move S by more than 1 % of the path.
std::string why_no_distance(const CoupledSliding& sliding, const CoupledSliding& more);

/// Histories at the times of the loads; where loads jump, before the jump.
struct CoupledHistory {
  Eigen::RowVectorXd shear;     ///< F_T (N/m)
  Eigen::RowVectorXd normal;    ///< N' (N/m)
  Eigen::RowVectorXd velocity;  ///< s' (m/s)
  Eigen::RowVectorXd slip;      ///< s (m)
  Eigen::MatrixXd outputs;      ///< the readings that the model was asked for
};

/// The steps of one length, for all phases.
struct SlipLevel {
  double length = 0.;  ///< s
  std::array<SlipSteps, 4> steps;
};

/// Computes the sliding of one model under any number of waves; const and safe to share between threads.
///
/// The caisson sticks while |F_T| <= mu N', slips with F_T = +-mu N' until s' = 0, and moves freely where N' would be
/// negative. Every phase is a sum of modes (slip_model.h), exact for loads that are straight between their samples;
/// energy coordinates pass from phase to phase. A change of phase is found as a root inside the step, so that it is
/// exact. While the caisson sticks, changes are looked for at the samples only, so one that is undone within the same
/// step is missed: take steps of a 20th of the shortest period that matters. While it moves no change is missed, as
/// friction with N' < 0 or along the motion would be a source of energy. Where the bends of s' and N' within a step
/// (slip_steps.h) leave room for a change, the step is halved, down to a radian of the fastest mode. s is the exact
/// integral of s'. Dissipated energy takes F_T as straight between samples: error of order step^2.
class CoupledSlip {
 public:
  /// `step` of the samples (s).
  CoupledSlip(SlipModel model, double step);

  const SlipModel& model() const { return model_; }
  double step() const { return step_; }

  /// From rest. Loads in rows, the last of them N_0, as in SlipPhase; two or more samples in columns, at t = 0, step,
  /// ... A slip that goes on at the last sample is followed until it stops, under loads that keep their last values.
  /// Throws std::invalid_argument where the loads are not the model's, NumericsError where the caisson never stops
  /// under them, or where too many changes of phase follow each other.
  CoupledSliding slide(const Eigen::Ref<const WaveSamples>& loads, CoupledHistory* history = nullptr) const;
  /// For loads with times of their own, each of which costs new exponentials, and with jumps.
  CoupledSliding slide(const SampledLoads& loads, CoupledHistory* history = nullptr) const;

 private:
  SlipModel model_;
  double step_;
  std::vector<SlipLevel> levels_;
};

}  // namespace upbead
