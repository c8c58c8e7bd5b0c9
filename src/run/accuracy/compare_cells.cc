#include <algorithm>

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
Scene compared(const Simulation& simulation) {
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

/// Results by reduced models; none where the models do not converge.
std::optional<CellsCompared::Reduced> by_reduced_models(const Simulation& simulation, const Simulation& on_finer) {
  const CompiledScene& finer = *on_finer.compiled();
  const Scene scene = compared(simulation);
  ReductionTargets targets;
  targets.only_shear = true;
  // both systems have the same loads
  const auto response = [&](const GrowingModel& model) {
    return respond(model.reduction(), scene, simulation.system());
  };
  const auto read = [&](const GrowingModel& model) { return bonded_answers(simulation, response(model)); };
  const Layout among = layout_of(simulation.system());
  try {
    GrowingModel own(simulation.system(), reduce_options(scene, *simulation.compiled(), targets),
                     simulation.room().get());
    CellsCompared::Reduced compared;
    {
      GrowingModel better(finer.system, reduce_options(scene, finer, targets), on_finer.room().get());
      if (!grow_side_by_side(own, better, read, share_of_difference * scene.tolerance, among)) return std::nullopt;
      compared.coarse = response(own);
      compared.finer = response(better);
    }
    grow_to_its_end(own, among);
    if (!among.first_says(own.reduction().converged)) return std::nullopt;
    compared.own = response(own);
    return compared;
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

ShearError by_march(const Simulation& simulation, const CompiledScene& finer) {
  const double step = choose_step(compared(simulation), *simulation.compiled(), 4).largest_step;
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

CellsCompared compare_cells(const Simulation& simulation) {
  const bool slips = may_slip(simulation) && !simulation.system().interface;
  const Simulation finer = slips ? with_room(with_halved_cells(simulation)) : with_halved_cells(simulation);
  CellsCompared out;
  out.reduced = by_reduced_models(simulation, finer);
  if (out.reduced && slips) out.finer = std::make_shared<const Simulation>(finer);
  const auto shear = [&](const Response& response) { return shear_history(*simulation.compiled(), response); };
  out.error = with_margin(out.reduced ? difference(shear(out.reduced->coarse), shear(out.reduced->finer))
                                      : by_march(simulation, *finer.compiled()));
  return out;
}

void agree(CellsCompared& compared, const Layout& among) {
  among.take_first(compared.error.peak);
  among.take_first(compared.error.history);
  if (among.largest(compared.reduced ? 0. : 1.) == 0.) return;
  compared.reduced.reset();
  compared.finer.reset();
}

}  // namespace upbead
