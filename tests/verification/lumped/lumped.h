// Caissons without a mesh: systems of one and two degrees of freedom built by hand, and the extremes of their
// readings over a march. The table's conventions: F_T = P - m x_G'', the dashpot included.
#pragma once

#include <string>

#include "upbead/dynamics/march.h"
#include "upbead/system/system.h"

namespace upbead::test {

/// m x'' + c x' + k x = P with m = 1 kg and the period 1 s. Readings: shear_force k x + c x', spring_force k x, and
/// the rate of each (named with _rate).
System one_degree(double zeta, const TimeFunction& force);

/// A caisson on springs for sway and rotation of its base.
struct SwayAndRotation {
  double mass = 0.;               ///< m (kg/m)
  double moment_of_inertia = 0.;  ///< about the centre of gravity (kg m2/m)
  double centre_height = 0.;      ///< h_G, of the centre of gravity above the base (m)
  double force_height = 0.;       ///< h_P, of P above the base (m)
  double sway_stiffness = 0.;     ///< K_x (N/m per m)
  double rocking_stiffness = 0.;  ///< K_theta (N m per m)
  double zeta = 0.;               ///< of both modes
};

/// Unknowns: sway of the base, rotation. Readings: shear_force, base_moment, and the rate of each.
System two_degrees(const SwayAndRotation& caisson, const TimeFunction& force);
/// The longer of its two undamped periods (s).
double longer_period(const SwayAndRotation& caisson);

/// Marches from rest with steps of at most `step`, without the balance of energy.
Response march_with(SchemeKind kind, const System& system, double end, double step);

/// Largest value of sign * reading over a march, inside the steps by the cubic through values and rates at their ends.
double extreme(const System& system, const Response& response, const std::string& reading, int sign);

/// A force that rises to `value` within `rise` (s) from `start` on and stays there; it jumps where rise = 0.
TimeFunction ramp(double value, double start, double rise);
/// A triangle of height `value` that rises for `rise` and is over at `duration` (s).
TimeFunction pulse(double value, double rise, double duration);

/// A title for figures and pages: "SDIRK4, 200 steps a period".
std::string title(SchemeKind kind, double steps_a_period);

}  // namespace upbead::test
