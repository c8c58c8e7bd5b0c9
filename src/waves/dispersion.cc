#include "upbead/waves/dispersion.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/constants.h"
#include "require_positive.h"

namespace upbead {

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
