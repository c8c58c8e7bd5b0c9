// How a scene is solved in time where the case does not say so: the scheme, and the step.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "fem/compile.h"
#include "response/load_step.h"

namespace upbead {

struct SchemeChoice {
  TimeScheme scheme = TimeScheme::sdirk4;  ///< never automatic
  std::string reason;                      ///< for the user, with the numbers
  std::optional<int> most_vectors;         ///< per load: a reduced model that has not converged with so many gives up
  std::string solves{};                    ///< of a march, about how many, for the user; "" where the reason tells them
};

/// A reduced model where it takes less work than marching and gives all that the case asks for; a scheme that the
/// case states is always kept.
SchemeChoice choose_scheme(const Scene& scene, const CompiledScene& compiled);

struct StepChoice {
  double largest_step = 0.;          ///< s
  double apparent_period = 0.;       ///< of the caisson on its ground (s); 0 where there is none
  std::optional<StepGrowth> growth;  ///< as in LoadStep
  std::string reason;                ///< for the user, with the numbers
  int factorisations = 0;            ///< for the choice itself
  double seconds = 0.;               ///< wall time of the choice
};

/// Apparent periods of one System, and the factorisations that each took: by s, and by the height of the force.
using KnownPeriods = std::map<std::pair<double, double>, std::pair<double, int>>;

/// The same fraction, of the shorter of the loads' duration and the caisson's apparent period; of the period alone
/// where there is only a lone jump. The apparent period is that of the caisson's mass m, with the added mass of
/// modelled water, on the stiffness k = F / x_G - m s^2, which one solve of (s^2 M + s C + K) x = b gives at the real
/// s = pi / duration: so it depends on s. b is a horizontal unit force F at the height of the largest horizontal load
/// on the caisson, else through its centre of gravity G. `known`: of the same System; those that are missing come in.
StepChoice choose_step(const Scene& scene, const CompiledScene& compiled, int order, KnownPeriods* known = nullptr);

}  // namespace upbead
