#include "finer.h"

#include <algorithm>

#include "../compile_on.h"
#include "../size_check.h"
#include "shear_difference.h"
#include "upbead/base/error.h"
#include "upbead/mesh/refine.h"
#include "upbead/response/reduction.h"
#include "upbead/response/step_choice.h"

namespace upbead {

namespace {

/// What the truth lies away over what halving the cells moves. Where every halving leaves a share q of the error that
/// is 1/(1 - q): 2 where the corners of a rigid bottom decide (stress as r^(-1/2), F_T wrong by the square of the error
/// in energy, q = 1/2), less where waves do; the rest is for meshes that are not so fine yet. Measured:
/// docs/accuracy.md.
constexpr double margin_of_peak = 3.4, margin_of_history = 4.;
/// Of what the history moves by; a change of the peak that is smaller is so by chance.
constexpr double least_share_of_history = 0.3;
/// Both solutions may be wrong in time by this part of the tolerance.
constexpr double share_of_time = 0.25;

/// The soil of cells that were split.
SoilState of_children(const SoilState& soil, const Mesh& mesh, const Mesh& finer) {
  SoilState state;
  state.shear_modulus.reserve(finer.triangulation.n_active_cells());
  for (const auto& cell : finer.triangulation.active_cell_iterators()) {
    const dealii::Triangulation<dim>::cell_iterator parent(&mesh.triangulation, cell->level() - 1,
                                                           cell->parent()->index());
    const unsigned i = parent->active_cell_index();
    if (!soil.shear_modulus.empty()) state.shear_modulus.push_back(soil.shear_modulus[i]);
    if (!soil.damping_ratio.empty()) state.damping_ratio.push_back(soil.damping_ratio[i]);
  }
  return state;
}

/// The scene as it is solved for a comparison: more exactly in time, at times of our own.
Scene compared(const CompiledCase& compiled) {
  Scene scene = compiled.scene;
  scene.tolerance *= share_of_time;
  scene.time.step.reset();
  return scene;
}

std::optional<ShearHistory> by_reduced_model(const CompiledCase& compiled) {
  const Scene scene = compared(compiled);
  ReductionAim aim;
  aim.only_shear = true;
  try {
    const Reduction reduction = reduce_scene(scene, compiled.compiled, aim);
    if (!reduction.converged) return std::nullopt;
    return shear_history(compiled.compiled, respond(reduction, scene, compiled.compiled.system), true);
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

ShearHistory by_march(const CompiledCase& compiled, double step) {
  const System& system = compiled.compiled.system;
  const auto scheme = make_scheme(system, {SchemeKind::sdirk4, 0., false});
  const TimeGrid grid = make_time_grid(kinks(system), compiled.scene.time.end, step);
  return shear_history(compiled.compiled, march(system, *scheme, grid), true);
}

/// `soil`: what has followed the strain.
CompiledCase compile_like(const Case& input, const CompiledCase& scene, const std::shared_ptr<const Mesh>& mesh,
                          const SoilState& soil) {
  CompiledCase other = compile_on(input, mesh);
  if (!scene.soil && other.with_interface == scene.with_interface) return other;
  other.with_interface = scene.with_interface;
  recompile(other, scene.soil ? soil : other.soil_state);
  return other;
}

}  // namespace

CompiledCase compile_finer(const Case& input, const CompiledCase& scene) {
  const std::shared_ptr<const Mesh> mesh = halved(*scene.mesh);
  return compile_like(input, scene, mesh,
                      scene.soil ? of_children(scene.soil_state, *scene.mesh, *mesh) : scene.soil_state);
}

CompiledCase compile_again(const Case& input, const CompiledCase& scene) {
  return compile_like(input, scene, scene.mesh, scene.soil_state);
}

ShearError with_margin(const ShearError& moved) {
  return {std::max(margin_of_peak * moved.peak, least_share_of_history * moved.history),
          margin_of_history * moved.history};
}

ShearError error_of_cells(const Case& input, const CompiledCase& scene, const CompiledCase& finer) {
  const std::optional<ShearHistory> reduced = by_reduced_model(scene);
  if (reduced)
    if (const auto better = by_reduced_model(finer)) return with_margin(difference(*reduced, *better));
  Scene timed = compared(scene);
  const double step = choose_step(timed, scene.compiled, 4).largest_step;
  check_steps(input, step, {}, "for an estimate of the mesh's error");
  return with_margin(difference(by_march(scene, step), by_march(finer, step)));
}

}  // namespace upbead
