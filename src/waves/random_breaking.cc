#include "upbead/waves/random_breaking.h"

#include <algorithm>
#include <cmath>

#include "upbead/waves/dispersion.h"

namespace upbead {

namespace {

/// K_s = 1 / sqrt((1 + 2kh/sinh 2kh) tanh kh).
double small_amplitude_shoaling(const Approach& a, double gravity) {
  const double kh = relative_wave_number(a.period, a.depth, gravity);
  return 1. / std::sqrt((1. + 2. * kh / std::sinh(2. * kh)) * std::tanh(kh));
}

/// beta_0, beta_1 and beta_max of H_1/3, or those of H_max with a star.
struct BreakingCoefficients {
  double deep, depth, largest;
};

BreakingCoefficients of_significant(double steepness, double slope) {
  return {0.028 * std::pow(steepness, -0.38) * std::exp(20. * std::pow(slope, 1.5)), 0.52 * std::exp(4.2 * slope),
          std::max(0.92, 0.32 * std::pow(steepness, -0.29) * std::exp(2.4 * slope))};
}

BreakingCoefficients of_highest(double steepness, double slope) {
  return {0.052 * std::pow(steepness, -0.38) * std::exp(20. * std::pow(slope, 1.5)), 0.63 * std::exp(3.8 * slope),
          std::max(1.65, 0.53 * std::pow(steepness, -0.29) * std::exp(2.4 * slope))};
}

}  // namespace

double shoaling(const Approach& a, double gravity) {
  const double L0 = deep_water_wavelength(a.period, gravity);
  return small_amplitude_shoaling(a, gravity) +
         0.0015 * std::pow(a.depth / L0, -2.87) * std::pow(a.deep_water_height / L0, 1.27);
}

DesignHeights design_heights(const Approach& a, double gravity) {
  const double H0 = a.deep_water_height, L0 = deep_water_wavelength(a.period, gravity);
  const double shoaled = shoaling(a, gravity) * H0;
  if (a.depth / L0 >= 0.2) return {shoaled, 1.8 * shoaled};
  const BreakingCoefficients s = of_significant(H0 / L0, a.bed_slope), m = of_highest(H0 / L0, a.bed_slope);
  DesignHeights heights;
  heights.significant = std::min({s.deep * H0 + s.depth * a.depth, s.largest * H0, shoaled});
  const double depth_b = a.depth + 5. * heights.significant * a.bed_slope;
  heights.highest = std::min({m.deep * H0 + m.depth * depth_b, m.largest * H0, 1.8 * shoaled});
  return heights;
}

}  // namespace upbead
