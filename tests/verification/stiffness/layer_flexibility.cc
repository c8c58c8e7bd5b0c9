#include "layer_flexibility.h"

#include <Eigen/LU>

namespace upbead::test {

namespace {

using Complex = std::complex<double>;

/// Rayleigh's function: only waves that travel or decay downwards.
Flexibility half_plane(double k, Complex ks2, Complex p, Complex s) {
  const Complex rayleigh = (2. * k * k - ks2) * (2. * k * k - ks2) - 4. * k * k * p * s;
  return {-s * ks2 / rayleigh, -p * ks2 / rayleigh, -k * (2. * k * k - ks2 - 2. * p * s) / rayleigh};
}

/// Two waves downwards and two upwards, each with amplitude 1 where it starts; tractions at the top, no motion at the
/// base.
Flexibility layer(const ElasticSoil& soil, double k, Complex p, Complex s) {
  const double lambda = 2. * soil.nu / (1. - 2. * soil.nu);
  Eigen::Matrix4cd conditions;
  Eigen::Matrix<Complex, 2, 4> top;
  for (int wave = 0; wave < 4; ++wave) {
    const bool pressure = wave % 2 == 0, upward = wave >= 2;
    const Complex decay = pressure ? p : s, rate = upward ? decay : -decay, far = std::exp(-decay * soil.depth);
    const Complex X = pressure ? Complex(k) : rate, Z = pressure ? rate : Complex(k);
    const Complex at_top = upward ? far : 1., at_base = upward ? 1. : far;
    top.col(wave) << X * at_top, Z * at_top;
    conditions.col(wave) << -(rate * X + k * Z) * at_top, -(lambda * (rate * Z - k * X) + 2. * rate * Z) * at_top,
        X * at_base, Z * at_base;
  }
  Eigen::Matrix<Complex, 4, 2> tractions = Eigen::Matrix<Complex, 4, 2>::Zero();
  tractions(0, 0) = tractions(1, 1) = 1.;
  const Eigen::Matrix2cd C = top * conditions.partialPivLu().solve(tractions);
  return {C(0, 0), C(1, 1), 0.5 * (C(0, 1) + C(1, 0))};
}

}  // namespace

Flexibility surface_flexibility(const ElasticSoil& soil, double k, Complex omega) {
  const Complex ks2 = omega * omega, kp2 = ks2 / std::pow(soil.pressure_wave_speed(), 2);
  const Complex p = std::sqrt(k * k - kp2), s = std::sqrt(k * k - ks2);
  return soil.is_layer() ? layer(soil, k, p, s) : half_plane(k, ks2, p, s);
}

}  // namespace upbead::test
