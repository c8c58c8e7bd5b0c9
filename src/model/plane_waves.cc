#include "model/plane_waves.h"

#include <cmath>

namespace upbead {

namespace {

using Complex = std::complex<double>;

/// Roots of a z^2 + b z + c = 0, the larger first, without cancellation.
struct Roots {
  Complex larger, smaller;
};

Roots roots(Complex a, Complex b, Complex c) {
  const Complex d = std::sqrt(b * b - 4. * a * c);
  const Complex q = 0.5 * (std::abs(-b + d) > std::abs(-b - d) ? -b + d : -b - d);
  return {q / a, c / q};
}

}  // namespace

PlaneWaves plane_waves(const Material& m, Flow flow, Complex s) {
  const Complex damped = 1. + s * m.stiffness_damping, skeleton = m.rho * (1. + m.mass_damping / s);
  const Complex G = m.G * damped, E = m.constrained_modulus() * damped;
  if (flow == Flow::drained) return {s * s * skeleton / G, s * s * skeleton / E, 0.};
  const bool inertial = flow == Flow::inertial;
  const Complex theta = 1. / ((inertial ? m.a * s * s : Complex(0.)) + m.b * s);
  const Complex carried = inertial ? s * s * m.rho_f * theta : Complex(0.);  // W = -carried u where p is uniform
  const Complex density = skeleton - carried * m.rho_f, c = m.alpha - carried;
  const Roots compression =
      roots(E * theta, -(E * m.storage + s * s * density * theta + c * c), s * s * density * m.storage);
  return {s * s * density / G, compression.smaller, compression.larger};
}

}  // namespace upbead
