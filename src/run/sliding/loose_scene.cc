#include "loose_scene.h"

#include <algorithm>

#include "base/text.h"
#include "upbead/base/error.h"

namespace upbead {

std::string why_no_slip(const Simulation& simulation) {
  const System& system = simulation.compiled->system;
  if (system.is_divided()) return "several processes share the work";
  if (!simulation.scene.time.inertia) return "consolidation has no dynamics";
  const std::string& region = simulation.compiled->caisson->body.region;
  const std::vector<Body>& bodies = simulation.compiled->bodies;
  if (std::none_of(bodies.begin(), bodies.end(), [&region](const Body& body) { return body.region == region; }))
    return "the caisson deforms";
  if (!bottom_is_level(*simulation.mesh)) return "the caisson's bottom is not level";
  return "";
}

CompiledScene compile_loose(const Simulation& simulation) {
  const std::vector<InterfaceNode> nodes = interface_nodes(*simulation.space);
  const Unknowns unknowns(*simulation.space, simulation.scene, simulation.compiled->bodies, nodes);
  return compile(simulation.scene, *simulation.space, unknowns, simulation.compiled->bodies, nullptr, nodes);
}

SlipUplift slip_uplift(const SlidingChoice& choice) {
  const bool computed = choice.uplift && choice.uplift->kind == UpliftKind::computed;
  return computed ? SlipUplift::computed : SlipUplift::none;
}

SlipReduction reduce_loose(const Scene& scene, const CompiledScene& loose, const Series& glued,
                           const std::function<void(double)>& progress) {
  SlipReduction reduction = reduce_slip(scene, loose, slip_uplift(*scene.sliding), glued, progress);
  constexpr double tolerable = 0.02;  // of forces that S is told with: an undamped scene needs many vectors for less
  if (!reduction.converged && !(reduction.error.history <= tolerable))
    throw NumericsError("the forces of its reduced model move by " + significant(reduction.error.history) +
                        " of their peaks between nested models with " + std::to_string(reduction.n_vectors) +
                        " vectors");
  return reduction;
}

}  // namespace upbead
