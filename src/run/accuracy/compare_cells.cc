#include <algorithm>
#include <cmath>

#include "dynamics/growing_model.h"
#include "fem/caisson/readings.h"
#include "mesh/refine.h"
#include "response/reduction.h"
#include "response/time_choice.h"
#include "run/accuracy/accuracy.h"
#include "run/accuracy/side_by_side.h"
#include "run/derived.h"
#include "run/sliding/case_sliding.h"
#include "run/sliding/slip_ahead.h"
#include "run/solve.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// The distance to the exact solution, as a multiple of the change when cells are halved. Where every halving leaves
/// a share q of the error it is 1/(1 - q): 2 where the corners of a rigid bottom govern (stress as r^(-1/2), the
/// error of F_T the square of the error in energy, q = 1/2), less where waves govern; the rest is for coarser meshes.
/// Measured: docs/accuracy.md.
constexpr double margin_of_peak = 3.4, margin_of_history = 4.;
/// Share of the history's change: a smaller change of the peak is a coincidence.
constexpr double least_share_of_history = 0.3;
/// Share of the tolerance by which time steps may make both solutions wrong.
constexpr double share_of_time = 0.25;
/// The change on a finer mesh, by the sum of its cells' errors to this power: measured on nested meshes, where of F_T
/// at any time it fell faster in 9 of 10, and the change of its peak, which is small by chance on some, more slowly.
constexpr double order_of_history = 0.75, order_of_others = 0.25;
/// By how much the difference of reduced models may still change, as a share of the tolerance of each.
constexpr double share_of_difference = 0.05;

/// The state of the soil in the cells that came from splitting.
SoilState of_children(const SoilState& soil, const Mesh& mesh, const Mesh& finer) {
  SoilState state;
  state.shear_modulus.reserve(finer.triangulation.n_active_cells());
  for (const auto& cell : finer.triangulation.active_cell_iterators()) {
    const dealii::Triangulation<dim>::cell_iterator parent(&mesh.triangulation, cell->level() - 1,
                                                           cell->parent()->index());
    const unsigned i = parent->active_cell_index();
    if (!soil.shear_modulus.empty()) state.shear_modulus.push_back(soil.shear_modulus[i]);
    if (!soil.damping_ratio.empty()) state.damping_ratio.push_back(soil.damping_ratio[i]);
    if (!soil.pore_fluid.empty()) state.pore_fluid.push_back(soil.pore_fluid[i]);
    if (!soil.conductivity.empty()) state.conductivity.push_back(soil.conductivity[i]);
  }
  return state;
}

/// The scene as solved for a comparison: more accurately in time, at the program's own steps.
Scene compared_scene(const Simulation& simulation) {
  Scene scene = simulation.scene();
  scene.tolerance = share_of_time * whole_tolerance(simulation);
  scene.time.step.reset();
  return scene;
}

/// F_T over time, and S by eq. (4).
Answers bonded_answers(const Simulation& simulation, const Response& response) {
  const CompiledScene& compiled = *simulation.compiled();
  Answers answers{response.ends.reading.row(compiled.system.reading(reading::shear_force)).transpose()};
  if (const auto sliding = sliding_of(simulation.scene(), compiled, response))
    answers.push_back(Eigen::VectorXd::Constant(1, sliding->history.by_history.residual));
  return answers;
}

ReductionTargets only_shear() {
  ReductionTargets targets;
  targets.only_shear = true;
  return targets;
}

/// A model for F_T alone, in the simulation's room.
GrowingModel growing_model(const Simulation& simulation, const Scene& scene) {
  return {simulation.system(), reduce_options(scene, *simulation.compiled(), only_shear()), simulation.room().get()};
}

/// Results on both meshes by reduced models; none where the models do not converge.
std::optional<CellsCompared::Reduced> by_reduced_models(const Simulation& simulation, const Simulation& on_finer) {
  const CompiledScene& finer = *on_finer.compiled();
  const Scene scene = compared_scene(simulation);
  // both systems have the same loads
  const auto response = [&](const GrowingModel& model) {
    return respond(model.reduction(), scene, simulation.system());
  };
  const auto read = [&](const GrowingModel& model) { return bonded_answers(simulation, response(model)); };
  const Layout among = layout_of(simulation.system());
  try {
    GrowingModel own = growing_model(simulation, scene);
    GrowingModel better(finer.system, reduce_options(scene, finer, only_shear()), on_finer.room().get());
    if (!grow_side_by_side(own, better, read, share_of_difference * scene.tolerance, among)) return std::nullopt;
    return CellsCompared::Reduced{response(own), response(better), {}};
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

ShearError by_march(const Simulation& simulation, const CompiledScene& finer) {
  const double step = choose_step(compared_scene(simulation), *simulation.compiled(), 4).largest_step;
  check_steps(simulation.scene(), step, {}, "for an estimate of the mesh's error");
  const auto shear = [&](const CompiledScene& on) {
    const TimeGrid grid = make_time_grid(kinks(on.system), simulation.scene().time.end, step);
    return marched_shear(on, SchemeKind::sdirk4, grid);
  };
  return difference(shear(*simulation.compiled()), shear(finer));
}

}  // namespace

Simulation with_halved_cells(const Simulation& simulation, bool with_interface) {
  const std::shared_ptr<const Mesh> mesh = halved(*simulation.mesh());
  Simulation::Parts other = resolved_on(simulation.given(), mesh);
  other.with_interface = with_interface;
  if (simulation.soil()) other.soil_state = of_children(simulation.soil_state(), *simulation.mesh(), *mesh);
  return assembled(std::move(other));
}

Simulation with_halved_cells(const Simulation& simulation) {
  return with_halved_cells(simulation, simulation.with_interface());
}

Simulation assembled_again(const Simulation& simulation) {
  Simulation::Parts other = resolved_on(simulation.given(), simulation.mesh());
  other.with_interface = simulation.with_interface();
  if (simulation.soil()) other.soil_state = simulation.soil_state();
  return assembled(std::move(other));
}

ShearError with_margin(const ShearError& moved) {
  return {std::max(margin_of_peak * moved.peak, least_share_of_history * moved.history),
          margin_of_history * moved.history};
}

namespace {

CellsCompared compare_with(const Simulation& simulation, const Simulation& finer) {
  CellsCompared out;
  out.reduced = by_reduced_models(simulation, finer);
  if (out.reduced && finer.room()) out.finer = std::make_shared<const Simulation>(finer);
  const auto shear = [&](const Response& response) { return shear_history(*simulation.compiled(), response); };
  out.error = with_margin(out.reduced ? difference(shear(out.reduced->coarse), shear(out.reduced->finer))
                                      : by_march(simulation, *finer.compiled()));
  return out;
}

/// With room where slip can be asked of the scene.
Simulation to_compare_slip(const Simulation& finer) {
  return may_slip(finer) && !finer.system().interface ? with_room(finer) : finer;
}

}  // namespace

CellsCompared compare_cells(const Simulation& given) {
  const Simulation simulation = with_room(given);  // so that complete() goes on with the basis
  const Simulation finer = to_compare_slip(with_halved_cells(simulation));
  CellsCompared out = compare_with(simulation, finer);
  const bool reduced = out.reduced.has_value();
  complete(out, simulation);
  if (reduced && !out.reduced) out.error = with_margin(by_march(simulation, *finer.compiled()));
  return out;
}

CellsCompared compare_cells(const Simulation& simulation, const std::vector<bool>& split) {
  return compare_with(simulation, to_compare_slip(on_mesh(simulation.given(), refined(*simulation.mesh(), split))));
}

void complete(CellsCompared& compared, const Simulation& simulation) {
  if (!compared.reduced) return;
  const Scene scene = compared_scene(simulation);
  const Layout among = layout_of(simulation.system());
  try {
    GrowingModel model = growing_model(simulation, scene);
    grow_to_its_end(model, among);
    if (among.first_says(model.reduction().converged)) {
      compared.reduced->own = respond(model.reduction(), scene, simulation.system());
      return;
    }
  } catch (const NumericsError&) {
    // another solution is needed
  }
  compared.reduced.reset();
  compared.coarse.reset();
  compared.finer.reset();
}

CellsCompared carried(const CellsCompared& compared, const Simulation& coarse, double share) {
  CellsCompared out = compared;
  out.share_of_slip = std::pow(share, order_of_others);
  out.error = {out.share_of_slip * compared.error.peak, std::pow(share, order_of_history) * compared.error.history};
  if (out.finer) out.coarse = std::make_shared<const Simulation>(coarse);
  return out;
}

void agree(CellsCompared& compared, const Layout& among) {
  among.take_first(compared.error.peak);
  among.take_first(compared.error.history);
  if (among.largest(compared.reduced ? 0. : 1.) == 0.) return;
  compared.reduced.reset();
  compared.coarse.reset();
  compared.finer.reset();
}

}  // namespace upbead
