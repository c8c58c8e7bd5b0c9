// How far the waves of one sea state slide a caisson, by their height.
#pragma once

#include <memory>

#include "upbead/expected/wave_forces.h"

namespace upbead {

enum class Law {
  paper,     ///< eq. (7) of Shimosako and Takahashi (1994)
  exact,     ///< the integral of their eqs. (4) and (6)
  combined,  ///< Shimosako and Takahashi (1998): a standing wave and a pulse, added mass
  dynamic,   ///< the caisson's own shear force F_T(t) under an impulsive force
};

/// Its word in files.
const char* word(Law law);

/// Safe to share between threads.
class SlidingLaw {
 public:
  virtual ~SlidingLaw() = default;
  /// S of a wave (m); not negative.
  virtual double distance(double height, const WaveFactors& factors = {}) const = 0;
  /// Whether a wave of that height is above the threshold, which is much cheaper than to find it.
  virtual bool may_slide(double height, const WaveFactors& factors = {}) const { return height > threshold(factors); }
  /// A height (m) below which no wave slides; infinity where none does.
  virtual double threshold(const WaveFactors& factors = {}) const = 0;
};

/// The law paper, exact or combined. Throws std::invalid_argument for the law dynamic, which needs a model, and where
/// Goda's formulas refuse the section at the sea state's water level.
std::unique_ptr<SlidingLaw> formula_law(Law law, const Breakwater& breakwater, const SeaState& state);

}  // namespace upbead
