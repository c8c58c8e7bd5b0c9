// The step in time as far as it depends on the loads alone.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "upbead/dynamics/time_grid.h"
#include "upbead/model/scene.h"

namespace upbead {

/// The step as far as it depends on the loads alone.
struct LoadStep {
  double largest_step = 0.;          ///< s
  double duration = 0.;              ///< the shortest of the loads (s)
  std::string load;                  ///< the load with that duration; "" where it is the span of the run
  bool lone_jump = false;            ///< there is only a jump, which has no duration: a 20th of the end replaces it
  std::optional<StepGrowth> growth;  ///< in consolidation, once the loads keep their values: up to a 50th of the end
};

/// A fraction of the loads' shortest duration, by the tolerance on peak F_T and the order of the scheme; measured in
/// docs/performance.md. Where a load jumps, the duration is the shortest of those stated and of twice the least
/// distance of two kinks (of any load).
LoadStep step_of_loads(const Scene& scene, int order);

/// Fraction of the duration for a step of a scheme of that order, measured for a tolerance of 0.5 %:
/// docs/performance.md.
double step_fraction(const Scene& scene, int order);

/// Steps with contact, as a multiple of those of other schemes of order 2: its stages are a quarter of a step. A 32nd
/// of the duration makes S and peak F_T wrong by less than 0.5 %: docs/slip.md.
constexpr double contact_step = 2.;
/// Number of these steps that are taken as one by order 4 while no node moves: an 8th of the duration, the step of
/// order 4 without contact; both at a tolerance of 0.5 %. For a larger tolerance, steps of order 4 grow less.
inline int contact_leap(double tolerance) {
  return static_cast<int>(4. * std::min(1., std::pow(tolerance / 0.005, 1. / 4. - 1. / 2.)));
}

}  // namespace upbead
