// Forces of the waves of one sea state on the caisson, with what scatters.
#pragma once

#include "upbead/expected/sea_state.h"
#include "upbead/sliding/combined.h"
#include "upbead/waves/goda.h"
#include "upbead/waves/shear_duration.h"

namespace upbead {

/// What is known for sure.
struct Breakwater {
  Section section;
  Water water;
  DurationFactor k;        ///< tau_0 = k tau_0F
  CombinedModel combined;  ///< of the law combined
};

/// What one wave makes of it, as factors.
struct WaveFactors {
  double force = 1.;     ///< of P
  double uplift = 1.;    ///< of U
  double friction = 1.;  ///< of mu
  double weight = 1.;    ///< of W; the buoyancy W - W' stays
};

/// W, W' and mu after the factors.
Section with_factors(const Section& section, const WaveFactors& factors);

/// Goda's forces at the water level of the sea state.
class WaveForces {
 public:
  WaveForces(const Breakwater& breakwater, const SeaState& state);
  /// At the water level of the sea state.
  const Breakwater& breakwater() const { return breakwater_; }
  double period() const { return period_; }
  WavePressure at(double height, const WaveFactors& factors, PressureFormula formula = PressureFormula::extended) const;
  /// F_Smax - mu W' (N/m), with alpha*.
  double excess(double height, const WaveFactors& factors) const;
  /// The height where it is zero (m), from below to the last digits; infinity where no wave of 1 km gets there.
  double threshold(const WaveFactors& factors) const;

 private:
  Breakwater breakwater_;
  double period_;
  Goda goda_;
};

}  // namespace upbead
