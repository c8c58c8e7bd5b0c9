// The triangular pulse of Shimosako and Takahashi (1994) and how far it slides a block, in closed form.
#pragma once

#include "upbead/sliding/block.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// F_S(t) of eq. (6): from 0 to the peak in half the duration, and back.
struct TriangularPulse {
  double peak = 0.;      ///< F_Smax (N/m)
  double duration = 0.;  ///< tau_0 (s)
};

/// The points of the pulse.
History history(const TriangularPulse& pulse);

/// S by eq. (7), g tau_0^2 (F_Smax - mu W')^3 (F_Smax + mu W') / (8 mu W' W F_Smax^2), in m; zero for F_Smax <= mu W'.
/// It assumes F_S = 0 from the moment when F_S falls below mu W', and therefore gives less than eqs. (4) and (6). mass:
/// W/g in air (kg/m); resistance: mu W' (N/m). Throws std::invalid_argument where one is not positive or the duration
/// is negative.
double sliding_distance_paper(double mass, double resistance, const TriangularPulse& pulse);

/// The two parts of eq. (7): S_1 = g tau_0^2 (F_Smax - mu W')^3 / (4 W F_Smax^2) until F_S has fallen to mu W', and S_2
/// while the block brakes without F_S (m).
struct PaperParts {
  double accelerating = 0., braking = 0.;
};
PaperParts sliding_distance_paper_parts(double mass, double resistance, const TriangularPulse& pulse);

/// S by integrating eqs. (4) and (6) exactly (m). With r = F_Smax / (mu W') and C = mu W' tau_0^2 / mass it is
/// C (1/4 + sqrt(2)/6) (r - 1)^3 / r^2 where the block stops within the pulse, r <= 1 + 1/sqrt(2), and
/// C/8 ((r - 1)^2 - 1/(12 r^2)) beyond; 1.94 times eq. (7) at r -> 1, 1.12 times at r = 3. Throws as eq. (7) does.
double sliding_distance_exact(double mass, double resistance, const TriangularPulse& pulse);

/// What slides the caisson in one wave.
struct SlidingLoad {
  double resistance = 0.;  ///< mu W' (N/m)
  double mass = 0.;        ///< W/g (kg/m)
  TriangularPulse pulse;   ///< F_Smax = P + mu U and tau_0 of eqs. (8)-(11)
};

/// The pulse of a wave of height H and period T with the pressures that it makes.
SlidingLoad sliding_load(const Section& section, const Water& water, const WavePressure& pressure, double height,
                         double period, const DurationFactor& k = {});

}  // namespace upbead
