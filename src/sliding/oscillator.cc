#include "oscillator.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace upbead::detail {

Oscillator::Oscillator(double mass, double damping, double stiffness)
    : mass_(mass), damping_(damping), stiffness_(stiffness) {
  if (mass == 0.) return;
  const std::complex<double> half(-damping / (2. * mass), 0.);
  std::complex<double> split = std::sqrt(half * half - stiffness / mass);
  // two equal roots would need another form: they are set apart by what nobody sees
  if (std::abs(split) < 1e-6 * std::abs(half)) split = 1e-6 * half;
  root_[0] = half + split;
  root_[1] = half - split;
}

/// x = A exp(r_0 t) + B exp(r_1 t) + (force + slope t)/k - c slope/k^2.
Motion Oscillator::after(double t, const Motion& start, double force, double slope) const {
  const double v_static = slope / stiffness_, x_static = force / stiffness_ - damping_ * v_static / stiffness_;
  if (mass_ == 0.) return {x_static + v_static * t, v_static};
  const double dx = start.x - x_static, dv = start.v - v_static;
  const std::complex<double> B = (dv - root_[0] * dx) / (root_[1] - root_[0]), A = dx - B;
  const std::complex<double> a = A * std::exp(root_[0] * t), b = B * std::exp(root_[1] * t);
  return {(a + b).real() + x_static + v_static * t, (root_[0] * a + root_[1] * b).real() + v_static};
}

double Oscillator::acceleration(const Motion& at, double force) const {
  return mass_ == 0. ? 0. : (force - damping_ * at.v - stiffness_ * at.x) / mass_;
}

double Oscillator::natural_period() const {
  return 2. * boost::math::constants::pi<double>() * std::sqrt(mass_ / stiffness_);
}

}  // namespace upbead::detail
