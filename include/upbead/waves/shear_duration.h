// How long the shear force of one wave lasts, after Shimosako and Takahashi (1994), eqs. (8)-(11).
#pragma once

namespace upbead {

/// tau_0F = (1/2 - H/(8 h)) T (s), eq. (11), stated for 0 <= H/h <= 0.8; kept at its last value 0.4 T beyond
/// (our extension; it keeps tau_0F continuous).
double standing_duration(double height, double depth, double period);

/// k(alpha*) of eqs. (8)-(9): tau_0 = k tau_0F. Committees calibrate a and b.
struct DurationFactor {
  double a = 0.3, b = 2.;
  /// k = 1 / (alpha*^a + 1)^b; alpha* is taken for 0 where it is negative.
  double operator()(double alpha_star) const;
};

}  // namespace upbead
