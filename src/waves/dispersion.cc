#include "upbead/waves/dispersion.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace upbead {

namespace {

constexpr double two_pi = boost::math::constants::two_pi<double>();

void require_positive(double value, const char* name) {
  if (!(value > 0. && std::isfinite(value)))
    throw std::invalid_argument(std::string("the dispersion of waves needs a finite ") + name + " above 0");
}

}  // namespace

double relative_wave_number(double period, double depth, double gravity) {
  require_positive(period, "period");
  require_positive(depth, "depth");
  require_positive(gravity, "gravity");
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
  require_positive(period, "period");
  require_positive(gravity, "gravity");
  return gravity * period * period / two_pi;
}

}  // namespace upbead
