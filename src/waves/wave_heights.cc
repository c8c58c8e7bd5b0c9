#include "upbead/waves/wave_heights.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
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

constexpr double surf = 0.2;  ///< h/L_0 from which waves do not break
/// Powers of H_0'/L_0 in beta_0 and beta_max.
constexpr double deep_power = -0.38, largest_power = -0.29;

/// beta_0, beta_1 and beta_max of H_1/3, or those of H_max with a star.
struct BreakingCoefficients {
  double deep, depth, largest;
};

BreakingCoefficients of_significant(double steepness, double slope) {
  return {0.028 * std::pow(steepness, deep_power) * std::exp(20. * std::pow(slope, 1.5)), 0.52 * std::exp(4.2 * slope),
          std::max(0.92, 0.32 * std::pow(steepness, largest_power) * std::exp(2.4 * slope))};
}

BreakingCoefficients of_highest(double steepness, double slope) {
  return {0.052 * std::pow(steepness, deep_power) * std::exp(20. * std::pow(slope, 1.5)), 0.63 * std::exp(3.8 * slope),
          std::max(1.65, 0.53 * std::pow(steepness, largest_power) * std::exp(2.4 * slope))};
}

/// The addition to K_s for a finite height.
double finite_shoaling(const Approach& a, double L0) {
  return 0.0015 * std::pow(a.depth / L0, -2.87) * std::pow(a.deep_water_height / L0, 1.27);
}

/// `small`: K_s of small waves.
DesignHeights heights_of(const Approach& a, double L0, double small) {
  const double H0 = a.deep_water_height;
  const double shoaled = (small + finite_shoaling(a, L0)) * H0;
  DesignHeights heights{shoaled, 1.8 * shoaled};
  if (a.depth / L0 >= surf) return heights;
  const BreakingCoefficients s = of_significant(H0 / L0, a.bed_slope), m = of_highest(H0 / L0, a.bed_slope);
  heights.significant = std::min({s.deep * H0 + s.depth * a.depth, s.largest * H0, shoaled});
  const double depth_b = a.depth + 5. * heights.significant * a.bed_slope;
  heights.breaker = m.deep * H0 + m.depth * depth_b;
  heights.highest = std::min({heights.breaker, m.largest * H0, 1.8 * shoaled});
  return heights;
}

/// H_0'/L_0 that shoals to `relative_height` H/L_0, by Newton's method. The function is convex: from a start above
/// the root the guesses fall until rounding stops them.
double shoaled_from(double relative_height, double relative_depth, double small) {
  const double finite = 0.0015 * std::pow(relative_depth, -2.87);
  double s = std::min(relative_height / small, std::pow(relative_height / finite, 1. / 2.27));
  for (double last = HUGE_VAL; s < last;) {
    last = s;
    const double part = finite * std::pow(s, 1.27);
    s -= ((small + part) * s - relative_height) / (small + 2.27 * part);
  }
  return s;
}

}  // namespace

double shoaling(const Approach& a, double gravity) {
  return small_amplitude_shoaling(a, gravity) + finite_shoaling(a, deep_water_wavelength(a.period, gravity));
}

DesignHeights design_heights(const Approach& a, double gravity) {
  return heights_of(a, deep_water_wavelength(a.period, gravity), small_amplitude_shoaling(a, gravity));
}

SeaBefore sea_before(double significant_height, Approach place, double gravity) {
  require_positive(significant_height, "significant height", "the sea in deep water needs");
  const double L0 = deep_water_wavelength(place.period, gravity), small = small_amplitude_shoaling(place, gravity);
  const double x = significant_height / L0, depth = place.depth / L0;
  // Each branch of H_1/3 grows with H_0', and H_1/3 is the least of them: H_0' is the largest of their inverses.
  double steepness = shoaled_from(x, depth, small);
  if (depth < surf) {
    const BreakingCoefficients one = of_significant(1., place.bed_slope);  // beta_0, beta_max: powers of steepness
    const double broken = std::pow(std::max(x - one.depth * depth, 0.) / one.deep, 1. / (1. + deep_power));
    const double sloping = 0.32 * std::exp(2.4 * place.bed_slope);
    const double largest = std::min(x / 0.92, std::pow(x / sloping, 1. / (1. + largest_power)));
    steepness = std::max({steepness, broken, largest});
  }
  constexpr double steepest = 0.142 / 1.8;
  place.deep_water_height = std::min(steepness, steepest) * L0;
  return {place.deep_water_height, steepness <= steepest, heights_of(place, L0, small)};
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
