#include "upbead/response/scheme_choice.h"

#include <algorithm>

#include "upbead/base/text.h"
#include "upbead/dynamics/time_grid.h"
#include "upbead/response/step_choice.h"

namespace upbead {

namespace {

constexpr double solves_per_load = 42., solves_per_step = 5.;
/// Reduced only where a march takes more solves than this many times its vectors.
constexpr double worth_it = 2.;
constexpr std::size_t most_independent = 3;  ///< forces on a rigid caisson: two and a moment

std::string about(double n) {
  return "about " + significant(n, 2);
}

}  // namespace

SchemeChoice choose_scheme(const Scene& scene, const CompiledScene& compiled) {
  if (scene.time.scheme != TimeScheme::automatic) return {scene.time.scheme, "given in the case"};
  const auto march = [](const std::string& why) { return SchemeChoice{TimeScheme::sdirk4, why}; };
  if (!scene.time.inertia) return march("consolidation is marched");
  if (!compiled.caisson) return march("without a caisson there is no F_T to measure a reduced model's error with");
  if (scene.fields_every) return march("fields are asked for");
  if (scene.time.stop_at_energy) return march("it shall stop early");
  const System& system = compiled.system;
  const double step = scene.time.step.value_or(step_of_loads(scene, 4).largest_step);
  const double marched = solves_per_step * estimated_steps(kinks(system).size(), scene.time.end, step);
  const double reduced = solves_per_load * static_cast<double>(std::min(system.loads.size(), most_independent));
  if (marched < worth_it * reduced) return march(about(marched) + " solves, a reduced model takes " + about(reduced));
  return {TimeScheme::reduced, about(reduced) + " solves instead of " + about(marched) + " of a march"};
}

}  // namespace upbead
