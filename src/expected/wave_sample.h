// S over all waves of lives by a measure that is too dear for all of them, from few: importance sampling of waves, with
// the cheap law as a control variate (Owen and Zhou 2000; Peherstorfer, Willcox and Gunzburger 2018).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "upbead/expected/life.h"

namespace upbead {

/// What the dear measure says of a wave.
struct DearSlip {
  double sliding = 0.;    ///< S, not negative (m)
  double error = 0.;      ///< bound of its error (m)
  std::string why_not{};  ///< why there is no S; else ""
};

/// A wave that was drawn, once, and S by the cheap law (m).
struct SampledWave {
  DrawnWave wave;
  double block = 0.;
};

struct WaveDraw {
  std::size_t wave;  ///< index
  double weight;     ///< S times weight, summed over all draws, is the sum over all waves
  std::size_t way;
};

/// Waves of all waves of lives that slide the caisson by the cheap law under `loose_friction` times their friction.
struct WaveSample {
  static constexpr double loose_friction = 0.7, between = 0.85;
  static constexpr std::size_t ways = 4;  ///< to draw a wave

  std::vector<SampledWave> waves;
  std::vector<WaveDraw> draws;
  double block = 0.;  ///< S of all waves by the cheap law (m)
  double lives = 0.;  ///< relative standard error of that, of the lives; where it is 0, of S under the loose friction
  bool is_whole = true;  ///< all waves were taken
};

/// Draws two fifths of the waves with a probability proportional to S and, so that those which only the dear measure
/// slides are met, a fifth each by S under the loose friction, by S under one between, and all alike; waves that do not
/// slide under the loose friction are taken not to slide. `most`: number of draws; where there are no more waves than
/// that, all are taken. The draws depend on the seed alone.
WaveSample sample_waves(LifeSetup setup, int lives, int most);

/// The sum of S over all waves of the lives, by the dear measure (m).
struct DearSum {
  double sum = 0.;
  double standard_error = 0.;  ///< of the draw of waves alone; 0 where all were answered
  double measure_error = 0.;   ///< if the errors of all waves have one sign
  int freedom = 0;             ///< degrees of it; 0 where all were answered
  int unanswered = 0;          ///< waves without S, which were given the largest ratio to the cheap law of the others
  std::string why_not{};       ///< why there is no sum; else ""
};

/// `slips`: of the waves, in their order. There is no sum where more than a tenth of the draws has no answer.
DearSum estimate(const WaveSample& sample, std::vector<DearSlip> slips);

}  // namespace upbead
