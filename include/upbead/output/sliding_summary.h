// The object `sliding` of summary.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/sliding/history_sliding.h"

namespace upbead {

/// S by tau_0 of eqs. (8)-(11) of Shimosako and Takahashi (1994) and the run's own F_Smax.
struct PulseSliding {
  double standing_duration = 0.;  ///< tau_0F (s)
  double factor = 0.;             ///< k(alpha*)
  double duration = 0.;           ///< tau_0 (s)
  double paper = 0.;              ///< S_CAL, eq. (7) (m)
  PaperParts paper_parts;         ///< S_1 and S_2
  double exact = 0.;              ///< by integrating eqs. (4) and (6) (m)
};

/// S of a caisson that slips as a whole on the soil, mound and water of the scene, which it shakes.
struct CoupledSummary {
  Sliding slip;                          ///< over the mound
  double dissipated = 0.;                ///< by friction (J/m)
  double peak_shear = 0.;                ///< F_T of largest magnitude (N/m)
  double least_normal = 0.;              ///< least N' (N/m)
  double lifted_time = 0.;               ///< for so long N' would have been negative (s)
  int vectors = 0;                       ///< of its Krylov space; 0 where the glued caisson does not reach its friction
  double error = 0.;                     ///< of the forces between nested models, over their largest values
  double glued_error = 0.;               ///< of F_T while it sticks, against the glued solution, over its peak
  double growth = 0.;                    ///< of the fastest vibration that friction feeds (1/s)
  double damping_time = 0.;              ///< of the damping against fast ones: ratio omega/2 times it (s)
  double damping_effect = 0.;            ///< what twice that damping changes of S (m)
  std::optional<double> error_estimate;  ///< of S, by cells too large (m)
};

/// At the samples of the loads.
struct CoupledHistoryTable {
  std::vector<double> time;                       ///< s
  std::vector<double> shear_force, normal_force;  ///< F_T, N' (N/m)
  std::vector<double> velocity, slip;             ///< s' (m/s), s (m)
  std::vector<double> displacement;               ///< x_G, the slip included (m)
};

/// The triangular pulse with the peak and the impulse of F_S.
struct EqualImpulse {
  double duration = 0.;  ///< tau_0 (s)
  double paper = 0.;     ///< S_CAL, eq. (7) (m)
  double exact = 0.;     ///< by integrating eqs. (4) and (6) (m)
};

struct SlidingSummary {
  double weight = 0.;          ///< W (N/m)
  double buoyant_weight = 0.;  ///< W' (N/m)
  double friction = 0.;        ///< mu
  double drag = 0.;            ///< F_D over velocity (N s/m2)
  std::string uplift;          ///< none, prescribed or computed
  HistorySliding history;
  std::optional<PulseSliding> pulse;          ///< where the case names a wave
  std::optional<EqualImpulse> equal_impulse;  ///< where F_S has a landward peak
  std::optional<CoupledSummary> coupled;      ///< where it can be told
  std::string why_not_coupled;                ///< else
  bool coupled_failed = false;                ///< for the numerics, not for what the scene is
  std::optional<double> error_estimate;       ///< of S by eq. (4) on F_T(t) (m)
  std::string why_no_estimate;                ///< else
};

}  // namespace upbead
