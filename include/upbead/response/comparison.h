// How far a computed history lies from a measured one.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// Both over the times that they share.
struct Comparison {
  double peak_measured = 0.;  ///< of largest magnitude
  double peak_computed = 0.;  ///< largest in the direction of that peak
  double peak_ratio = 0.;     ///< computed over measured
  double rms = 0.;            ///< root of the mean square of the difference
  double rms_relative = 0.;   ///< over the root of the mean square of the measured one
  double phase = 0.;          ///< by which the computed one comes later: where both correlate best (s)
};

/// `measured` at `time` (ascending) against `computed` at `computed_time` (ascending), linear between. Throws
/// std::invalid_argument where they share fewer than two times, or the measured one is zero there.
Comparison compare(const std::vector<double>& time, const std::vector<double>& measured,
                   const std::vector<double>& computed_time, const std::vector<double>& computed);

}  // namespace upbead
