#include "run/monitors.h"

#include <cmath>

#include "fem/compile.h"
#include "response/reduction.h"
#include "response/time_choice.h"
#include "upbead/base/error.h"

namespace upbead {

Monitors::Monitors(const Simulation& simulation, bool shared_before) {
  const bool shared = simulation.processes() || shared_before;
  if (simulation.scene().limits.liquefaction && !shared) upward.emplace(*simulation.space(), *simulation.unknowns());
  const double level = water_level(simulation.scene(), *simulation.mesh());
  if (!std::isfinite(level))
    why_no_pressure = why_no_strength = why_no_cyclic = "no still water level is known: give [initial] water_level";
  else if (shared)
    why_no_pressure = why_no_strength = why_no_cyclic = "several processes share the work";
  if (!why_no_pressure.empty()) return;
  pressure.emplace(*simulation.space(), *simulation.unknowns(), simulation.scene(), level);
  const bool builds = builds_pressure(simulation.scene());
  if (!has_strength(simulation.scene()) && !builds) return;
  try {
    rest = solve_static(simulation.scene(), *simulation.mesh());
  } catch (const NumericsError& error) {
    why_no_strength = why_no_cyclic = error.what();
    return;
  }
  if (has_strength(simulation.scene()))
    strength.emplace(*simulation.space(), *simulation.unknowns(), rest->stress, k0_to_apply(simulation.scene()));
  if (builds) cyclic.emplace(*simulation.space(), *simulation.unknowns());
}

std::vector<MarchObserver*> Monitors::observers() {
  std::vector<MarchObserver*> list;
  if (pressure) list.push_back(&*pressure);
  if (strength) list.push_back(&*strength);
  if (cyclic) list.push_back(&*cyclic);
  if (upward) list.push_back(&*upward);
  return list;
}

std::shared_ptr<const Monitors> monitors_of(const Solution& solution) {
  if (solution.monitors) return solution.monitors;
  const Simulation& simulation = *solution.simulation;
  const auto monitors = std::make_shared<Monitors>(simulation);
  if (!solution.pressures && !solution.states) return monitors;
  const SampledLoads loads = sampled_loads(simulation.scene(), simulation.system());
  const double duration = step_of_loads(simulation.scene(), 4).duration;
  if (solution.pressures && monitors->pressure) monitors->pressure->see(*solution.pressures, loads, duration);
  if (solution.pressures && monitors->upward) monitors->upward->see(*solution.pressures, loads);
  if (solution.states && monitors->strength) monitors->strength->see(*solution.states, loads, duration);
  if (solution.states && monitors->cyclic) monitors->cyclic->see(*solution.states, loads, duration);
  return monitors;
}

}  // namespace upbead
