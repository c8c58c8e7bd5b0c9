// The time step where the case leaves it to us.
#pragma once

#include <string>

#include "upbead/fem/compile.h"

namespace upbead {

struct StepChoice {
  double largest_step = 0.;    ///< s
  double natural_period = 0.;  ///< of the caisson on its ground (s); 0 where there is none
  std::string reason;          ///< for people, with the numbers
  int factorisations = 0;      ///< that the choice itself took
  double seconds = 0.;         ///< wall time of it
};

/// A fraction of the shorter of the loads' duration and the caisson's natural period, by the tolerance on peak F_T and
/// the order of the scheme; measured in docs/accuracy.md. The natural period is that of the caisson's mass on the
/// stiffness k = F/x - m s^2 which one solve of (s^2 M + s C + K) x = b gives at the real s = pi / duration.
StepChoice choose_step(const Scene& scene, const CompiledScene& compiled, int order);

}  // namespace upbead
