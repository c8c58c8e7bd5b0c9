// The force of a wave that breaks on the caisson, over time: what a caisson's own dynamics are asked to answer.
#pragma once

#include "expected/shear_answer.h"
#include "upbead/waves/section.h"

namespace upbead {

/// How the uplift runs beside an impulsive force.
enum class ImpactUplift {
  held,        ///< U_max until T/4, then U_max sin(2 pi t/T): on the safe side
  in_phase,    ///< U_max P(t) / P_max
  sinusoidal,  ///< U_max sin(2 pi t/T)
};

/// Assumptions of ours: no published method tells the force history of a wave from its height.
struct ImpactAssumptions {
  double peak_gain = 0.5;          ///< e in P_I = P_1 (1 + e alpha*)
  double rise_coefficient = .769;  ///< c in t_r = c sqrt(d/g) / F*; 8.94 x 0.086
  double duration_least = 2.;      ///< t_d/t_r of the slowest rise
  double duration_gain = 8.;       ///< how much more of the fastest
  double duration_decay = 18.;     ///< t_d = t_r (least + gain exp(-decay t_r/T))
  ImpactUplift uplift = ImpactUplift::held;
};

/// A wave on the wall: P(t) = max(gamma P_1 sin(2 pi t/T), triangle) for 0 <= t <= T/2.
struct ImpactWave {
  double period = 0.;          ///< T (s)
  double standing_force = 0.;  ///< P_1, by alpha_1 alone (N/m)
  double reduction = 1.;       ///< gamma: half a period keeps the impulse P_1 T/pi
  double peak = 0.;            ///< P_I (N/m)
  double rise = 0.;            ///< t_r (s)
  double duration = 0.;        ///< t_d (s), at most T/2
  double uplift = 0.;          ///< U_max (N/m)
};

/// What Goda's formulas tell of a wave on the wall.
struct WaveOnWall {
  double height = 0.;          ///< H (m)
  double period = 0.;          ///< T (s)
  double standing_force = 0.;  ///< P_1 (N/m)
  double alpha_star = 0.;
  double uplift = 0.;  ///< U_max (N/m)
};

/// What the assumptions make of it. `berm_depth`: d (m). The triangle ends with the half period; it then rises in at
/// most half its duration.
ImpactWave impact_wave(const ImpactAssumptions& assumptions, const WaveOnWall& on_wall, const Water& water,
                       double berm_depth);

/// How large and steep its force is.
ForceLimits limits(const ImpactWave& wave);

/// How many samples at 0, step, 2 step, ... there are until T/2 is over.
int number_of_samples(const ImpactWave& wave, double step);
/// P and U at the first `n` of them.
void sample_force(const ImpactWave& wave, double step, int n, double* force);
void sample_uplift(const ImpactWave& wave, ImpactUplift shape, double step, int n, const double* force, double* uplift);

}  // namespace upbead
