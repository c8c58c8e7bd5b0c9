#include "finer.h"

#include <algorithm>

#include "../derived.h"
#include "../size_check.h"
#include "mesh/refine.h"
#include "response/reduction.h"
#include "response/step_choice.h"
#include "shear_difference.h"
#include "upbead/base/error.h"

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
Scene compared(const Simulation& simulation) {
  Scene scene = simulation.scene;
  scene.tolerance *= share_of_time;
  scene.time.step.reset();
  return scene;
}

std::optional<ShearHistory> by_reduced_model(const Simulation& simulation) {
  const Scene scene = compared(simulation);
  ReductionAim aim;
  aim.only_shear = true;
  try {
    const Reduction reduction = reduce_scene(scene, *simulation.compiled, aim);
    if (!reduction.converged) return std::nullopt;
    return shear_history(*simulation.compiled, respond(reduction, scene, simulation.compiled->system), true);
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

ShearHistory by_march(const Simulation& simulation, double step) {
  const System& system = simulation.compiled->system;
  const auto scheme = make_scheme(system, {SchemeKind::sdirk4, 0., false});
  const TimeGrid grid = make_time_grid(kinks(system), simulation.scene.time.end, step);
  return shear_history(*simulation.compiled, march(system, *scheme, grid), true);
}

/// `soil`: what has followed the strain.
Simulation like(const Simulation& simulation, const std::shared_ptr<const Mesh>& mesh, const SoilState& soil) {
  Simulation other = on_mesh(simulation.given, mesh);
  if (!simulation.soil && other.with_interface == simulation.with_interface) return other;
  other.with_interface = simulation.with_interface;
  if (simulation.soil) other.soil_state = soil;
  return assembled(std::move(other));
}

}  // namespace

Simulation with_halved_cells(const Simulation& simulation) {
  const std::shared_ptr<const Mesh> mesh = halved(*simulation.mesh);
  return like(simulation, mesh, of_children(simulation.soil_state, *simulation.mesh, *mesh));
}

Simulation assembled_again(const Simulation& simulation) {
  return like(simulation, simulation.mesh, simulation.soil_state);
}

ShearError with_margin(const ShearError& moved) {
  return {std::max(margin_of_peak * moved.peak, least_share_of_history * moved.history),
          margin_of_history * moved.history};
}

ShearError error_of_cells(const Simulation& simulation, const Simulation& finer) {
  const std::optional<ShearHistory> reduced = by_reduced_model(simulation);
  if (reduced)
    if (const auto better = by_reduced_model(finer)) return with_margin(difference(*reduced, *better));
  Scene timed = compared(simulation);
  const double step = choose_step(timed, *simulation.compiled, 4).largest_step;
  check_steps(simulation.given, step, {}, "for an estimate of the mesh's error");
  return with_margin(difference(by_march(simulation, step), by_march(finer, step)));
}

}  // namespace upbead
