// Steps in time that meet every kink of the loads.
#pragma once

#include <vector>

#include "upbead/system/system.h"

namespace upbead {

/// n_steps equal steps from `start` (s).
struct TimeSegment {
  double start = 0.;
  double step = 0.;
  int n_steps = 0;
};

/// Segments one after the other, from t = 0 to `end` (s).
struct TimeGrid {
  std::vector<TimeSegment> segments;
  double end = 0.;

  int n_steps() const;
  /// Number of step sizes that differ: of matrices to factorise.
  int n_step_sizes() const;
};

/// Steps of at most `largest_step` (s) that meet `end` (s) and every kink in (0, end); kinks closer than 1e-9 end
/// merge. Where there is a common step in [largest_step / 2, largest_step] that divides every distance between kinks
/// (to 1e-9 relative), it is used throughout, so that one factorisation does; else each segment has its own, equal ones
/// made bitwise equal. Throws std::invalid_argument where end or largest_step is not positive.
TimeGrid make_time_grid(std::vector<double> kinks, double end, double largest_step);

/// The kinks of all loads of a system, ascending.
std::vector<double> kinks(const System& system);

}  // namespace upbead
