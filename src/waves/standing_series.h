// The double Fourier series of a standing wave, and the conditions at the surface that determine its coefficients.
//
// Lengths in 1/k, times in 1/sqrt(g k), x seaward from the wall, y from still water, tau = omega t, K = kh:
//   eta = sum a_ij cos(i tau) cos(j x),   phi = sum b_ij sin(i tau) cos(j x) cosh j(y + K) / cosh jK,   i + j even,
// satisfy Laplace's equation, the conditions at the bed, at the wall and half a wavelength off, and keep the volume
// of the water. What remains are the conditions at y = eta,
//   kinematic   omega eta_tau + phi_x eta_x - phi_y = 0
//   dynamic     omega phi_tau + (phi_x^2 + phi_y^2)/2 + eta - c = 0
// with omega = (2 pi/T) sqrt(h/g) / sqrt(K), and eta(0, 0) - eta(pi, 0) = 2 K H/h.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "upbead/waves/standing_wave.h"

namespace upbead {

constexpr int largest_harmonic = 16;

/// One value for each harmonic in space, from 0 on; a series has few, so that they need no allocation.
using OfHarmonics = Eigen::Array<double, Eigen::Dynamic, 1, 0, largest_harmonic + 1, 1>;

/// The series at one time, which is a function of x and y alone: the harmonics in time are summed.
struct StandingInstant {
  OfHarmonics j, decay;      ///< the harmonics, and exp(-2 j K)
  OfHarmonics eta, eta_tau;  ///< of cos jx
  OfHarmonics phi, phi_tau;  ///< of cos jx cosh j(y + K) / cosh jK
  double K = 0., omega = 0., c = 0.;

  double surface(double x) const;             ///< eta
  double pressure(double x, double y) const;  ///< below the surface; includes -y of still water
  double downward_acceleration() const;       ///< of the surface at the wall, over g
};

struct StandingSeries {
  int n = 0;             ///< largest harmonic, at most largest_harmonic
  Eigen::MatrixXd a, b;  ///< row i, column j; 0 where i + j is odd, in column 0 of a and in row 0 of b
  double c = 0., K = 0.;
  double relative_height = 0.;  ///< H/h
  double deep_frequency = 0.;   ///< (2 pi/T) sqrt(h/g)
  double residual = 0.;         ///< StandingWave::residual, once the coefficients are found
  Eigen::VectorXd slope;        ///< how a, b, c and K change with H/h; may be empty

  double frequency() const;  ///< omega
  double swing() const;      ///< eta(0, 0) - eta(pi, 0)
  StandingInstant at(double tau) const;
};

/// Residuals of both conditions at a place of the surface.
struct SurfaceConditions {
  double kinematic = 0., dynamic = 0.;
};
SurfaceConditions surface_conditions(const StandingInstant& instant, double x);

/// A series of at most most_harmonics with that `residual` or less, or else with the smallest residual found; none
/// where Newton's method finds no wave. small_K: kh of a small wave of that period. `lower`: that of the same period
/// and at most that height, or nullptr; the search begins with its harmonics, as a higher wave needs no fewer.
std::optional<StandingSeries> solve_standing(double relative_height, double small_K, double residual,
                                             int most_harmonics, const StandingSeries* lower = nullptr);

}  // namespace upbead
