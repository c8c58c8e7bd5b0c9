// tau_0 of a history: how long the triangular pulse of equal peak would have to be.
#pragma once

#include <optional>
#include <vector>

#include "upbead/sliding/block.h"

namespace upbead {

/// tau_0 (s) of one history F_S(t) at one r = F_Smax / (mu W'), by several measures; none where there is no answer. It
/// is no property of the history alone: always state r and the formula with it.
struct HistoryDuration {
  double ratio = 0.;                 ///< r
  double sliding = 0.;               ///< S of the history, eq. (4) (m)
  std::optional<double> by_paper;    ///< the pulse slides as far by eq. (7)
  std::optional<double> by_exact;    ///< the pulse slides as far by eqs. (4) and (6)
  std::optional<double> by_excess;   ///< F_S exceeds mu W' for as long: that time / (1 - 1/r)
  std::optional<double> by_impulse;  ///< same impulse: twice that of the lobe with the peak, over the peak
};

/// The history against a resistance mu W' = F_Smax / r. Throws as slide() does, and std::invalid_argument where r <= 0
/// or F_S is nowhere above 0.
/// - mass: W/g (kg/m)
/// - force: F_S, landward positive (N/m)
HistoryDuration history_duration(double mass, const ForceHistory& force, double ratio);

/// F_Smax, the largest value (N/m), and the index of its point.
std::size_t peak_index(const ForceHistory& force);

}  // namespace upbead
