#include "run/safety.h"

#include "fem/rest_state.h"

namespace upbead {

std::optional<SafetySummary> find_safety(const Simulation& simulation) {
  if (!simulation.given.initial || !simulation.given.initial->safety) return std::nullopt;
  const SafetyFactor found = safety_factor(simulation.scene, *simulation.mesh, simulation.soil_state);
  return SafetySummary{found.lower, found.upper, found.fails_at};
}

}  // namespace upbead
