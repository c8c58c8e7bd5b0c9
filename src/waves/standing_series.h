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

struct StandingSeries {
  int n = 0;                      ///< largest harmonic
  Eigen::ArrayXd ai, aj, bi, bj;  ///< harmonics in time and in space of a and of b
  Eigen::VectorXd a, b;
  double c = 0., K = 0.;
  double relative_height = 0.;  ///< H/h
  double deep_frequency = 0.;   ///< (2 pi/T) sqrt(h/g)
  double residual = 0.;         ///< StandingWave::residual, once the coefficients are found

  double frequency() const;                               ///< omega
  double swing() const;                                   ///< eta(0, 0) - eta(pi, 0)
  double surface(double tau, double x) const;             ///< eta
  double pressure(double tau, double x, double y) const;  ///< below the surface; includes -y of still water
  double crest_acceleration() const;                      ///< downward, over g
};

/// Residuals of both conditions at a point of the surface, and, where asked for, their derivatives with respect to a,
/// b, c and K (one row of that many entries for each condition).
struct SurfaceConditions {
  double kinematic = 0., dynamic = 0.;
};
SurfaceConditions surface_conditions(const StandingSeries& series, double tau, double x,
                                     Eigen::RowVectorXd* kinematic_row = nullptr,
                                     Eigen::RowVectorXd* dynamic_row = nullptr);

/// A series of at most most_harmonics with that `residual` or less, or else with the smallest residual found; none
/// where Newton's method finds no wave. small_K: kh of a small wave of that period.
std::optional<StandingSeries> solve_standing(double relative_height, double small_K, double residual,
                                             int most_harmonics);

}  // namespace upbead
