// A rigid block on Coulomb friction: how far a force history slides it.
#pragma once

#include <vector>

#include "upbead/base/history.h"

namespace upbead {

/// The motion from a start to the next stop. Landward positive.
struct Slip {
  double start = 0., stop = 0.;  ///< s
  double distance = 0.;          ///< m
  double peak_velocity = 0.;     ///< of largest magnitude (m/s)
};

/// Motion of a block that was at rest at x = 0. Landward positive.
struct Sliding {
  double residual = 0.;     ///< x in the end: S of the paper, for one wave (m)
  double largest = 0.;      ///< x of largest magnitude on the way (m)
  double path = 0.;         ///< sum of the absolute distances of all slips (m)
  std::vector<Slip> slips;  ///< in order; a change of direction without rest ends one and begins the next
  /// x' when the forces end (m/s): where it is not 0 the block is braked by all of R from then on.
  double end_velocity = 0.;

  void add(const Slip& slip);
};

/// Solves (W/g) x'' = F_S(t) - F_D - R(t) sgn(x') from rest [Shimosako and Takahashi 1994, eq. (4) with F_S = F_T + mu
/// U, R = mu W']: the block starts where |F_S| exceeds R and stops where its velocity is zero and |F_S| does not exceed
/// R. It may slip landward and seaward, any number of times. On each linear piece the velocity is known in closed form,
/// so that starts and stops are roots of known functions (of linear and quadratic ones without drag), and no time steps
/// are needed.
/// - mass: W/g, in air (kg/m).
/// - force: F_S, zero before and after its points.
/// - resistance: R >= 0, with its first value before its points and its last value after them. Uplift that changes
///   with time may be part of F_S (exact while the block slides landward) or taken off R (exact both ways).
/// - drag: F_D = drag x' of eq. (2) (N s/m2 per metre); the paper neglects it.
/// Throws std::invalid_argument where the mass is not positive, a history has not as many values as times, is not
/// finite or goes back in time, resistance or drag is negative or has no value, or no resistance is left at the end to
/// stop the block.
Sliding slide(double mass, const History& force, const History& resistance, double drag = 0.);
/// The same with a constant resistance.
Sliding slide(double mass, const History& force, double resistance, double drag = 0.);

}  // namespace upbead
