// Sliding by the caisson's own dynamics: every wave's impulsive force goes through the reduced model of the caisson.
#pragma once

#include <memory>
#include <vector>

#include "expected/impact.h"
#include "expected/shear_answer.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

/// One wave, from its force to how far it slides the caisson.
struct DynamicWave {
  ImpactWave wave;
  std::vector<double> time, force, shear, sliding_force;  ///< P, F_T, F_S = F_T + mu U at the answer's steps
  double sliding = 0.;                                    ///< S (m)
};

/// S of F_S = F_T(t) + mu U(t) by slide(), with F_T the reduced model's answer to the force of impact_wave(). A scatter
/// of the weight changes the resistance and the mass that slides, not the model.
class DynamicLaw : public SlidingLaw {
 public:
  DynamicLaw(const Breakwater& breakwater, const SeaState& state, const ImpactAssumptions& assumptions,
             std::shared_ptr<const ShearAnswer> answer);
  double distance(double height, const WaveFactors& factors) const override;
  bool may_slide(double height, const WaveFactors& factors) const override;
  /// By a bound on the answer to any force of that peak: waves above it may still not slide.
  double threshold(const WaveFactors& factors) const override;
  /// Everything about one wave, also if it does not slide.
  DynamicWave wave(double height, const WaveFactors& factors = {}) const;

 private:
  ImpactWave on_wall(double height, const WaveFactors& factors) const;
  /// The largest |F_S| that such a wave might have, less mu W' (N/m).
  double most(const ImpactWave& wave, const Section& section) const;
  double slide_under(const DynamicWave& wave, const Section& section) const;

  WaveForces forces_;
  ImpactAssumptions assumptions_;
  std::shared_ptr<const ShearAnswer> answer_;
};

}  // namespace upbead
