// Displacements of the surface of an elastic layer or half-plane under harmonic tractions: the exact kernel in wave
// numbers.
#pragma once

#include <cmath>
#include <complex>
#include <limits>

namespace upbead::test {

/// Elastic soil in the units of the tables: shear modulus, density and half the strip's width are 1, so that the speed
/// of shear waves is 1 and an angular frequency is the dimensionless a0 = omega b / c_s.
struct ElasticSoil {
  double nu = 0.3;
  double depth = std::numeric_limits<double>::infinity();  ///< of the rigid base; infinite: a half-plane
  bool is_layer() const { return depth < std::numeric_limits<double>::infinity(); }
  /// Lowest frequency of waves along a layer: a quarter of a shear wave over its depth.
  double cut_off() const { return std::acos(-1.) / (2. * depth); }
  double pressure_wave_speed() const { return std::sqrt(2. * (1. - nu) / (1. - 2. * nu)); }
};

/// Displacements X, Z of the surface for tractions S, T on it, at one wave number k: u_x = -i X e^{-ikx} and
/// t_x = -i S e^{-ikx}, u_z = Z e^{-ikx} and t_z = T e^{-ikx}, z and t_z into the soil: (X, Z) = C (S, T), C symmetric
/// and real at omega = 0.
struct Flexibility {
  std::complex<double> xx, zz, xz;
};

/// At a frequency with a negative imaginary part (a little damping), which moves poles and branch points away from
/// real k and so distinguishes waves that carry energy outwards from the other waves, whatever the direction of their
/// crests.
Flexibility surface_flexibility(const ElasticSoil& soil, double k, std::complex<double> omega);

}  // namespace upbead::test
