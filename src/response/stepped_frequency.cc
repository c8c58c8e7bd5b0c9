#include "response/stepped_frequency.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace upbead {

namespace {

using Complex = std::complex<double>;

/// z h of generalised-alpha: -z^2 d = a, and v and d are updated by Newmark's formulas.
Complex of_alpha(Complex w) {
  constexpr double rho = 0.9, m = (2. * rho - 1.) / (rho + 1.), f = rho / (rho + 1.), gamma = 0.5 - m + f,
                   beta = 0.25 * (1. - m + f) * (1. - m + f);
  const Complex q = std::exp(w), moved = (1. - gamma) + gamma * q + (q - 1.) * (0.5 - beta + beta * q);
  const Complex square = ((1. - m) * q + m) * (q - 1.) * (q - 1.) / (((1. - f) * q + f) * moved);
  const Complex root = std::sqrt(square);
  return std::real(root * std::conj(w)) < 0. ? -root : root;
}

}  // namespace

bool SteppedFrequency::feels(Complex s) const {
  return s.imag() * steps_.size <= boost::math::constants::pi<double>();
}

Complex SteppedFrequency::operator()(Complex s) {
  if (steps_.size == 0.) return s;
  const Complex w = s * steps_.size;
  return (steps_.order == 2 ? of_alpha(w) : of_sdirk4(w)) / steps_.size;
}

Complex SteppedFrequency::of_sdirk4(Complex w) {
  Complex z = last_z_ + w - last_w_;
  const Complex aim = std::exp(w);
  for (int i = 0; i < 20; ++i) {
    const Complex base = 1. - 0.25 * z, below = std::pow(base, 5);
    const Complex above = 1. + z * (-0.25 + z * (-0.125 + z * (1. / 96. + z * 7. / 768.)));
    const Complex slope = -0.25 + z * (-0.25 + z * (1. / 32. + z * 7. / 192.));
    const Complex R = above / below, change = (R - aim) / (slope / below + 1.25 * R / base);
    z -= change;
    if (std::abs(change) < 1e-12) break;
  }
  last_w_ = w;
  last_z_ = z;
  return z;
}

}  // namespace upbead
