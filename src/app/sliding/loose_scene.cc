#include "loose_scene.h"

#include <algorithm>

#include "upbead/base/error.h"
#include "upbead/base/text.h"

namespace upbead {

std::string why_no_slip(const CompiledCase& scene) {
  const System& system = scene.compiled.system;
  if (system.is_divided()) return "several processes share the work";
  if (!scene.scene.time.inertia) return "consolidation has no dynamics";
  const std::string& region = scene.compiled.caisson->body.region;
  const std::vector<Body>& bodies = scene.compiled.bodies;
  if (std::none_of(bodies.begin(), bodies.end(), [&region](const Body& body) { return body.region == region; }))
    return "the caisson deforms";
  if (!bottom_is_level(*scene.mesh)) return "the caisson's bottom is not level";
  return "";
}

CompiledScene compile_loose(const CompiledCase& scene) {
  const std::vector<InterfaceNode> nodes = interface_nodes(*scene.space);
  const Unknowns unknowns(*scene.space, scene.scene, scene.compiled.bodies, nodes);
  return compile(scene.scene, *scene.space, unknowns, scene.compiled.bodies, nullptr, nodes);
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
