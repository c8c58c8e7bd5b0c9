#include "run/yielding_run.h"

#include <algorithm>

#include "base/progress.h"
#include "dynamics/yielding.h"
#include "fem/compile.h"
#include "fem/soil_laws.h"
#include "model/words.h"
#include "run/sliding/coupled_sliding.h"
#include "run/solve.h"

namespace upbead {

namespace {

RestStart start_of(const Scene& scene) {
  return scene.initial ? scene.initial->start : RestStart::k0;
}

bool is_hysteretic(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return entry.second.law == SoilLaw::hysteretic; });
}

bool wants_bounds(const Scene& scene) {
  return is_hysteretic(scene) && (!scene.initial || scene.initial->bounds);
}

double last(const CompiledScene& compiled, const Response& response, const char* reading) {
  const Series& ends = response.ends;
  return ends.reading(compiled.system.reading(reading), static_cast<Eigen::Index>(ends.time.size()) - 1);
}

ResidualSummary residual(const CompiledScene& compiled, const Response& response) {
  return {last(compiled, response, "caisson/displacement_x"), last(compiled, response, "caisson/displacement_y"),
          last(compiled, response, "caisson/rotation")};
}

/// Of the area of soil that yields, the cells in which it lost energy.
double share_yielded(const Space& space, const YieldingSoil& soil) {
  double yielded = 0., all = 0.;
  for (const auto& cell : space.mesh().triangulation.active_cell_iterators()) {
    const double lost = soil.dissipated()[cell->active_cell_index()];
    if (lost < 0.) continue;
    all += cell->measure();
    if (lost > 0.) yielded += cell->measure();
  }
  return all > 0. ? yielded / all : 0.;
}

Run march_from(const Simulation& simulation, RestStart start, const StaticStage& rest, const MarchOptions& marching,
               const Care& care) {
  const SoilLaws laws = soil_laws(simulation.scene, *simulation.space, rest.stress, start);
  const System& system = simulation.compiled->system;
  const auto soil = yielding_soil(*simulation.space, *simulation.unknowns, system.readings, laws.points);
  const auto scheme =
      make_yielding_scheme(system, *soil, {yielding_tolerance * simulation.given.tolerance, care.refined});
  Run run = march_by(*scheme, simulation, "soil that yields", marching, care.part);
  const YieldingReport& report = *scheme->yielding();
  NonlinearSummary& summary = run.summary.nonlinear.emplace();
  summary.start = is_hysteretic(simulation.scene) ? word_of(start, rest_start_words) : "static";
  summary.stages = report.stages;
  summary.iterations = report.evaluations;
  summary.factorisations = run.summary.discretisation.factorisations;
  summary.cut_steps = report.cut_steps;
  summary.share_yielded = share_yielded(*simulation.space, *soil);
  if (laws.report.area > 0.) summary.share_beyond_at_rest = laws.report.beyond / laws.report.area;
  if (simulation.compiled->caisson) run.summary.residual = residual(*simulation.compiled, run.response);
  return run;
}

Run climb_from(const Simulation& simulation, RestStart start, const StaticStage& rest, const MarchOptions& marching) {
  const auto solve = [&](const MarchOptions& options, const Care& care) {
    return march_from(simulation, start, rest, options, care);
  };
  return climb(simulation, ways_with_care(simulation.given, "yielding", solve), marching);
}

StartBound bound_of(const Run& run) {
  StartBound bound;
  bound.start = run.summary.nonlinear->start;
  bound.peak_shear = run.summary.response->peak_shear;
  bound.shear_to_force_ratio = run.summary.response->shear_to_force_ratio;
  bound.residual = *run.summary.residual;
  return bound;
}

}  // namespace

Run run_yielding(const Simulation& simulation, const MarchOptions& marching,
                 const std::function<void(double)>& progress) {
  const StaticStage rest = solve_static(simulation.scene, *simulation.mesh);
  const RestStart start = start_of(simulation.given);
  Run run = climb_from(simulation, start, rest, marching);
  if (simulation.compiled->caisson && wants_bounds(simulation.given)) {
    int n = 0;
    for (const auto& [word, other] : rest_start_words) {
      if (other == start) continue;
      ObserverFunction reported = progress_observer(part_of(progress, 0.5 * n, 0.5 * (n + 1)));
      MarchOptions silent;
      silent.observers = {&reported};
      run.summary.nonlinear->bounds.push_back(bound_of(climb_from(simulation, other, rest, silent)));
      ++n;
    }
  }
  SlipAhead none;
  read_sliding(simulation, none, run, {});
  return run;
}

}  // namespace upbead
