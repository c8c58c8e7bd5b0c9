// The sliding model of Shimosako and Takahashi (1998): a standing wave and an impulsive pulse, integrated in time.
#pragma once

#include "upbead/sliding/block.h"
#include "upbead/sliding/pulse.h"

namespace upbead {

/// The course in time of the uplift of a wave.
enum class UpliftShape {
  in_phase,    ///< U_max P(t) / max P: proportional to the force
  sinusoidal,  ///< gamma_U U_max sin(2 pi t / T) for 0 <= t <= T/2
};

/// Choices that the sources at hand leave open, with our defaults.
struct CombinedModel {
  double added_mass_factor = 1.0855;  ///< M_a / (rho h'^2); 2 x 0.5428, water on both sides of a wall
  UpliftShape uplift = UpliftShape::in_phase;
  double uplift_gain = 1.;  ///< gamma_U
};

/// One wave. P(t) = max(P_1, P_2) with P_1 = gamma_P P_1max sin(2 pi t / T) for 0 <= t <= T/2, and P_2 the triangle.
struct CombinedWave {
  double period = 0.;          ///< T (s)
  double standing_force = 0.;  ///< P_1max, by alpha_1 alone (N/m)
  TriangularPulse impulsive;   ///< P_2max, by alpha_1 and alpha*, and tau_0; 0 of a wave without force
  double uplift = 0.;          ///< U_max (N/m)
};

/// gamma_P in [0, 1], chosen so that P(t) has the impulse of half a standing wave, P_1max T / pi; 0 where P_2 alone has
/// more.
double standing_reduction(const CombinedWave& wave);

/// P(t) and U(t), linear between 400 points of the half period, the kinks of P_2 and the points where P_1 and P_2
/// cross.
History combined_force(const CombinedWave& wave);
History combined_uplift(const CombinedWave& wave, const CombinedModel& model = {});

/// M_a (kg/m).
double added_mass(double density, double foundation_depth, const CombinedModel& model = {});

/// S (m): (W/g + M_a) x'' = P + mu U - mu W', x' >= 0, integrated exactly between those points.
/// - mass: W/g + M_a (kg/m), as of added_mass().
/// - resistance: mu W' (N/m).
double sliding_distance_combined(double mass, double resistance, double friction, const CombinedWave& wave,
                                 const CombinedModel& model = {});

}  // namespace upbead
