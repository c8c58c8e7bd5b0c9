#include "response/scheme_choice.h"

#include <algorithm>
#include <cmath>

#include "response/step_choice.h"
#include "upbead/dynamics/time_grid.h"

namespace upbead {

namespace {

constexpr double usual_vectors_per_load = 46., solves_per_step = 5.;
constexpr std::size_t most_independent = 3;  ///< forces on a rigid caisson: two and a moment
/// Part of a march's work that may be lost on a reduced model that does not converge.
constexpr double risk = 1.;

std::string about(double n) {
  return "about " + std::to_string(10 * std::lround(n / 10.));
}

/// Work of a reduced model with so many vectors, in solves of a march: each vector is solved for, made orthogonal and
/// projected; the eigenvalues of all looks together take as long as 4 V^3 / n solves with n unknowns. Measured.
double work(double vectors, int unknowns) {
  return 1.5 * vectors + 4. * vectors * vectors * vectors / unknowns;
}

}  // namespace

SchemeChoice choose_scheme(const Scene& scene, const CompiledScene& compiled) {
  if (scene.time.scheme != TimeScheme::automatic) return {scene.time.scheme, "given in the case", {}};
  const auto march = [](const std::string& why) { return SchemeChoice{TimeScheme::sdirk4, why, {}}; };
  if (!scene.time.inertia) return march("consolidation is marched");
  if (!compiled.caisson) return march("without a caisson there is no F_T to measure a reduced model's error with");
  if (scene.fields_every) return march("fields are asked for");
  if (has_strength(scene)) return march("a strength needs the stresses of all cells");
  if (scene.time.stop_at_energy) return march("it shall stop early");
  const System& system = compiled.system;
  if (system.is_divided()) return march("several processes share the work");
  if (system.loads.empty()) return march("no load acts");
  const double step = scene.time.step.value_or(step_of_loads(scene, 4).largest_step);
  const double marched = solves_per_step * estimated_steps(kinks(system).size(), scene.time.end, step);
  const double n_loads = static_cast<double>(std::min(system.loads.size(), most_independent));
  const double reduced = usual_vectors_per_load * n_loads;
  if (const double equal = work(reduced, system.n_free()); marched < equal)
    return march(about(marched) + " solves; a reduced model would cost as much as " + about(equal));
  double most = reduced;
  while (work(most + 1., system.n_free()) < risk * marched) ++most;
  return {TimeScheme::reduced, about(reduced) + " solves instead of " + about(marched) + " of a march",
          static_cast<int>(most / n_loads)};
}

}  // namespace upbead
