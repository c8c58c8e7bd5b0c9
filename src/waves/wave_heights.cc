#include "upbead/waves/wave_heights.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/numbers.h"
#include "require_positive.h"

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
  DesignHeights heights{shoaled, 1.8 * shoaled};
  if (a.depth / L0 >= 0.2) return heights;
  const BreakingCoefficients s = of_significant(H0 / L0, a.bed_slope), m = of_highest(H0 / L0, a.bed_slope);
  heights.significant = std::min({s.deep * H0 + s.depth * a.depth, s.largest * H0, shoaled});
  const double depth_b = a.depth + 5. * heights.significant * a.bed_slope;
  heights.breaker = m.deep * H0 + m.depth * depth_b;
  heights.highest = std::min({heights.breaker, m.largest * H0, 1.8 * shoaled});
  return heights;
}

SeaBefore sea_before(double significant_height, Approach place, double gravity) {
  require_positive(significant_height, "significant height", "the sea in deep water needs");
  const auto of = [&place, gravity](double deep_water_height) {
    place.deep_water_height = deep_water_height;
    return design_heights(place, gravity);
  };
  const auto excess = [&](double H0) { return of(H0).significant - significant_height; };
  const double steepest = 0.142 / 1.8 * deep_water_wavelength(place.period, gravity);
  if (excess(steepest) <= 0.) return {steepest, excess(steepest) == 0., of(steepest)};
  std::uintmax_t most = 100;
  const double H0 = boost::math::tools::toms748_solve(excess, 1e-9 * std::min(steepest, significant_height), steepest,
                                                      boost::math::tools::eps_tolerance<double>(), most)
                        .first;
  return {H0, true, of(H0)};
}

double relative_wave_number(double period, double depth, double gravity) {
  require_positive(period, "period", "the dispersion of waves needs");
  require_positive(depth, "depth", "the dispersion of waves needs");
  require_positive(gravity, "gravity", "the dispersion of waves needs");
  const double omega = two_pi / period, y = omega * omega * depth / gravity;
  // x tanh(x) = y: tanh(x) < 1 and tanh(x) < x bound x from below, their sum bounds it from above.
  const double low = std::max(y, std::sqrt(y)), high = y + std::sqrt(y);
  const double guess = y / std::sqrt(std::tanh(y));  // Eckart
  const auto residual = [y](double x) {
    const double c = std::cosh(x);  // may be infinite, the slope is then 1
    return std::pair(x * std::tanh(x) - y, std::tanh(x) + x / c / c);
  };
  std::uintmax_t iterations = 50;
  return boost::math::tools::newton_raphson_iterate(residual, std::min(std::max(guess, low), high), low, high,
                                                    std::numeric_limits<double>::digits - 2, iterations);
}

double wavelength(double period, double depth, double gravity) {
  return two_pi * depth / relative_wave_number(period, depth, gravity);
}

double deep_water_wavelength(double period, double gravity) {
  require_positive(period, "period", "the dispersion of waves needs");
  require_positive(gravity, "gravity", "the dispersion of waves needs");
  return gravity * period * period / two_pi;
}

}  // namespace upbead
