// Steps in time, one of which ends at every kink of the loads.
#pragma once

#include <optional>
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
  /// Number of different step sizes, which is the number of matrices to factorise.
  int n_step_sizes() const;
};

/// Growth of the steps once the loads keep their values: from `after` (s) on, by `factor` every 8 steps, up to
/// `largest` (s).
struct StepGrowth {
  double after = 0.;
  double largest = 0.;
  double factor = 2.;  ///< above 1
};

/// Steps of at most `largest_step` (s) with step ends at `end` (s) and at every kink in (0, end); kinks closer than
/// 1e-9 end merge. Where one step in [largest_step / 2, largest_step] divides every distance between kinks (to 1e-9
/// relative), it is used throughout, so that one factorisation is enough. Else each segment has a step of its own;
/// equal ones are made bitwise equal. Steps grow only after `growth->after`, which is a kink. Throws
/// std::invalid_argument where end or largest_step is not positive or the steps are too many for an int.
TimeGrid make_time_grid(std::vector<double> kinks, double end, double largest_step,
                        const std::optional<StepGrowth>& growth = {});

/// Estimate of the steps of such a grid, without making it. Where a common step is found the grid has at most twice as
/// many.
double estimated_steps(std::size_t n_kinks, double end, double largest_step,
                       const std::optional<StepGrowth>& growth = {});

/// Whether f keeps its value from t on, judged by samples up to 7.1 h later. It is exact for a constant. The distances
/// of the samples are not all multiples of a period that steps of h resolve, so no harmonic passes for a constant.
bool keeps_value(const TimeFunction& f, double t, double h);

/// The kinks of all loads of a system, ascending.
std::vector<double> kinks(const System& system);

std::vector<TimeFunction> load_histories(const System& system);

}  // namespace upbead
