#include "run/yielding_run.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/progress.h"
#include "base/text.h"
#include "dynamics/joined.h"
#include "dynamics/yielding.h"
#include "fem/assembly.h"
#include "fem/compile.h"
#include "fem/rest_state.h"
#include "fem/soil_laws.h"
#include "model/soil_law_row.h"
#include "model/words.h"
#include "response/compaction.h"
#include "run/construction.h"
#include "run/derived.h"
#include "run/yielding_watch.h"
#include "system/part.h"

namespace upbead {

namespace {

RestStart start_of(const Scene& scene) {
  return scene.initial ? scene.initial->start : RestStart::k0;
}

bool has_start(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return starts_from(RestStress::given, entry.second); });
}

bool wants_bounds(const Scene& scene) {
  return has_start(scene) && (!scene.initial || scene.initial->bounds);
}

/// Where a motion ends, and between what it was in the last part of the run.
struct MotionAtEnd {
  double value = 0.;
  std::array<double, 2> range{0., 0.};
};

MotionAtEnd at_end(const CompiledScene& compiled, const Response& response, const char* reading) {
  constexpr double last_part = 0.2;
  const std::vector<double>& time = response.ends.time;
  const auto row = response.ends.reading.row(compiled.system.reading(reading));
  auto t = static_cast<Eigen::Index>(time.size()) - 1;
  MotionAtEnd end{row[t], {row[t], row[t]}};
  for (const double from = (1. - last_part) * time.back(); t >= 0 && time[static_cast<std::size_t>(t)] >= from; --t)
    end.range = {std::min(end.range[0], row[t]), std::max(end.range[1], row[t])};
  return end;
}

ResidualSummary residual(const Simulation& simulation, const Response& response) {
  const CompiledScene& compiled = *simulation.compiled();
  const MotionAtEnd x = at_end(compiled, response, "caisson/displacement_x"),
                    y = at_end(compiled, response, "caisson/displacement_y"),
                    rotation = at_end(compiled, response, "caisson/rotation");
  return {x.value,        y.value,
          rotation.value, pore_pressure_left(*simulation.space(), *simulation.unknowns(), response.final_state),
          x.range,        y.range,
          rotation.range};
}

/// Share of the area of soil that may yield in which cells lost energy: more than round-off of the mean over the area.
double share_yielded(const Space& space, const YieldingSoil& soil) {
  constexpr double round_off_of_mean = 1e-6;
  double yielded = 0., all = 0., lost_in_all = 0.;
  const auto for_each_cell = [&](const auto& visit) {
    for (const auto& cell : space.mesh().triangulation.active_cell_iterators())
      if (const double lost = soil.dissipated()[cell->active_cell_index()]; lost >= 0.) visit(area_of(cell), lost);
  };
  for_each_cell([&](double area, double lost) {
    all += area;
    lost_in_all += lost;
  });
  for_each_cell([&](double area, double lost) {
    if (lost > 0. && lost * all > round_off_of_mean * lost_in_all * area) yielded += area;
  });
  return all > 0. ? yielded / all : 0.;
}

/// The work of soil; a system whose interface is bonded lacks the interface's unknowns.
SoilWork work_of(const Simulation& simulation) {
  SoilWork work;
  const System& system = simulation.system();
  work.n_unknowns = whole_size(system);
  if (system.is_divided()) {
    work.divided = &system;
    work.own_cells = own_cells(*simulation.space(), *simulation.processes());
  }
  work.followed = followed_readings(*simulation.space(), simulation.scene());
  return work;
}

/// The state before the waves.
struct Rest {
  StaticStage elastic;
  std::optional<RestState> failing;                   ///< of Mohr-Coulomb soil, where one was found
  std::string why_none;                               ///< "" where one was found, and without such soil
  std::optional<ConstructionSummary> construction{};  ///< of such soil, where it is built in stages
};

RestSummary summary_of(const RestState& rest) {
  return {rest.report.steps, rest.report.iterations, rest.share_at_strength, rest.report.residual};
}

std::string why_none(const RestState& rest) {
  if (rest.found) return {};
  const std::string stage = rest.falls_in.empty() ? "" : "in the stage '" + rest.falls_in + "' of construction ";
  return stage +
         (rest.none ? "no stress within the strength is in equilibrium with the weights: the ground gives way in "
                    : "no state at rest was found, nor was it shown that there is none; the ground moves most in ") +
         rest.gives_way;
}

/// What the soil did in a march.
YieldingSolution yielding_of(const Simulation& simulation, RestStart start, const Rest& rest, const SoilLaws& laws,
                             const YieldingSoil& soil, const YieldingWatch& watch, const YieldingReport& report,
                             const Solution& solution) {
  YieldingSolution out;
  NonlinearSummary& found = out.found;
  found.start = has_start(simulation.scene()) ? word_of(start, rest_start_words) : "static";
  found.stages = report.stages;
  found.iterations = report.evaluations;
  found.factorisations = solution.discretisation.factorisations;
  found.cut_steps = report.cut_steps;
  found.share_skipped = soil.share_skipped();
  found.share_yielded = share_yielded(*simulation.space(), soil);
  if (laws.report.area > 0.) found.share_beyond_at_rest = laws.report.beyond / laws.report.area;
  if (!laws.compacting->empty())
    out.densification =
        compacted_soils(*simulation.space(), *simulation.unknowns(), *laws.compacting, solution.response.final_state);
  if (rest.failing) found.rest = summary_of(*rest.failing);
  found.why_no_rest = rest.why_none;
  found.peak_strain = watch.peak_strain();
  found.regions = watch.regions();
  if (simulation.compiled()->caisson) out.residual = residual(simulation, solution.response);
  return out;
}

Solution march_from(const Simulation& simulation, RestStart start, const Rest& rest, const Marching& marching,
                    const Way& way, const NodeFollower& nodes) {
  const SoilLaws laws = soil_laws(simulation.scene(), *simulation.space(), rest.elastic.stress, start,
                                  rest.failing ? &rest.failing->stresses : nullptr);
  const System& system = simulation.system();
  const auto soil =
      yielding_soil(*simulation.space(), *simulation.unknowns(), system.readings, laws.points, work_of(simulation));
  const auto scheme = make_yielding_scheme(
      system, *soil, {yielding_tolerance * whole_tolerance(simulation), way.refined, rest.elastic.weight});
  if (marching.soil) marching.soil(*soil);
  YieldingWatch watch(*simulation.space(), *simulation.unknowns(), *soil);
  WholeStates watching(system, watch);
  Marching followed = marching;
  followed.observers.push_back(&watching);
  if (MarchObserver* observer = nodes.begin ? nodes.begin(*scheme) : nullptr)
    followed.observers.insert(followed.observers.begin(), observer);
  Solution solution = march_by(*scheme, simulation, "soil that yields", followed, way.part);
  solution.discretisation.why_scheme += "; " + percent(soil->share_skipped()) +
                                        " of the updates of cells were left out, as no soil in those cells could yield";
  if (system.is_divided()) solution.response.final_state = joined(system, solution.response.final_state);
  solution.yielding = yielding_of(simulation, start, rest, laws, *soil, watch, *scheme->yielding(), solution);
  if (nodes.end) solution.contact = nodes.end();
  if (solution.contact && system.is_divided())
    solution.contact->found.solved->dissipated = solution.response.energy.back().friction;  // of all processes
  return solution;
}

Solution climb_from(const Simulation& simulation, RestStart start, const Rest& rest, const Marching& marching,
                    const NodeFollower& nodes = {}) {
  const auto solve = [&](const Way& way, const Marching& options) {
    return march_from(simulation, start, rest, options, way, nodes);
  };
  return climb(simulation, ways_to_march(simulation.scene(), "yielding"), marching, solve);
}

StartBound bound_of(const Simulation& simulation, const Solution& solution) {
  const ShearResponse shear =
      read_shear_response(*simulation.compiled(), solution.response, simulation.scene().time.inertia);
  StartBound bound;
  bound.start = solution.yielding->found.start;
  bound.peak_shear = shear.peak_shear;
  bound.shear_to_force_ratio = shear.shear_to_force_ratio;
  bound.residual = *solution.yielding->residual;
  return bound;
}

}  // namespace

Solution run_yielding(const Simulation& simulation, const Marching& marching, const NodeFollower& nodes, bool bounds) {
  Rest rest{solve_static(simulation.scene(), *simulation.mesh()), {}, {}};
  if (needs_rest_state(simulation.scene())) {
    RestState found =
        rest_state(simulation.scene(), *simulation.mesh(), simulation.soil_state(), shown_progress("state at rest"));
    rest.why_none = why_none(found);
    rest.construction = construction_of(simulation, found);
    if (found.found) rest.failing = std::move(found);
  }
  const RestStart start = start_of(simulation.scene());
  Solution solution = climb_from(simulation, start, rest, marching, nodes);
  solution.construction = rest.construction;
  solution.simulation = std::make_shared<const Simulation>(simulation);
  if (bounds && simulation.compiled()->caisson && wants_bounds(simulation.scene())) {
    int n = 0;
    for (const auto& [word, other] : rest_start_words) {
      if (other == start) continue;
      ObserverFunction reported = progress_observer(part_of(marching.beside, 0.5 * n, 0.5 * (n + 1)));
      Marching silent;
      silent.observers = {&reported};
      solution.yielding->found.bounds.push_back(bound_of(simulation, climb_from(simulation, other, rest, silent)));
      ++n;
    }
  }
  return solution;
}

}  // namespace upbead
