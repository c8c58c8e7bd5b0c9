// How far one wave slides the caisson, by several measures.
#pragma once

#include <optional>
#include <vector>

#include "upbead/sliding/block.h"
#include "upbead/sliding/pulse.h"

namespace upbead {

/// tau_0 (s) of one history F_S(t) at one r = F_Smax / (mu W'), by several measures; none where there is no answer.
/// tau_0 is not a property of the history alone: always state r and the formula with it.
struct HistoryDuration {
  double ratio = 0.;                ///< r
  double sliding = 0.;              ///< S of the history, eq. (4) (m)
  std::optional<double> by_paper;   ///< the pulse slides as far by eq. (7)
  std::optional<double> by_exact;   ///< the pulse slides as far by eqs. (4) and (6)
  std::optional<double> by_excess;  ///< F_S exceeds mu W' for as long: that time / (1 - 1/r)
  /// Same impulse: twice the impulse of the lobe with the peak (the part above 0 around it), over the peak.
  std::optional<double> by_impulse;
};

/// tau_0 of the history with a resistance mu W' = F_Smax / r. Throws as slide() does, and std::invalid_argument where r
/// <= 0 or F_S is nowhere above 0.
/// - mass: W/g (kg/m)
/// - force: F_S, landward positive (N/m)
HistoryDuration history_duration(double mass, const History& force, double ratio);

/// F_Smax, the largest value (N/m), and the index of its point.
std::size_t peak_index(const History& force);

/// What acts at the bottom in one wave. Landward and upward positive, per metre.
struct BottomForces {
  History shear_force;    ///< F_T (N/m)
  History uplift;         ///< U, never below 0; without points there is none (N/m)
  History normal_change;  ///< N' - (W' - U), from the caisson's vertical motion and loads (N/m)
};

/// What resists sliding.
struct BottomResistance {
  double mass = 0.;              ///< W/g (kg/m)
  double friction = 0.;          ///< mu
  double submerged_weight = 0.;  ///< W' (N/m)
  double drag = 0.;              ///< F_D over velocity (N s/m2)
};

struct HistorySliding {
  double peak_force = 0.;         ///< F_Smax, largest F_T + mu U (N/m)
  double peak_force_time = 0.;    ///< s
  double peak_seaward = 0.;       ///< largest -F_T + mu U, which slides it seaward (N/m)
  double peak_seaward_time = 0.;  ///< s
  /// Largest F_T and -F_T, each minus mu times the change of N', by U and by the caisson's vertical motion (N/m).
  double peak_on_normal = 0., peak_seaward_on_normal = 0.;
  double shear_at_peak = 0.;           ///< F_T at peak_force_time (N/m)
  double uplift_at_peak = 0.;          ///< U at peak_force_time (N/m)
  double resistance = 0.;              ///< mu W' (N/m)
  double ratio = 0.;                   ///< r = F_Smax / (mu W')
  double least_normal_force = 0.;      ///< least N' = W' - U + change; below 0 the caisson would lift (N/m)
  Sliding by_history;                  ///< eq. (4) with N' = W' - U
  Sliding with_normal_force;           ///< eq. (4) with N' = W' - U + change
  std::optional<HistoryDuration> own;  ///< tau_0 at its own r; none where F_S is nowhere landward
  std::vector<HistoryDuration> table;  ///< tau_0 at r = 1.05 to 2
};

/// S by integrating eq. (4) with N' = W' - U alone.
Sliding slide_on_history(const BottomForces& forces, const BottomResistance& bottom);

/// S by integrating eq. (4) of Shimosako and Takahashi (1994). Friction acts on N', not below 0. Throws as slide()
/// does.
HistorySliding slide_history(const BottomForces& forces, const BottomResistance& bottom);

}  // namespace upbead
