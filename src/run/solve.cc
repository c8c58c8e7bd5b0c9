#include "run/solve.h"

#include <algorithm>
#include <cmath>
#include <list>

#include "base/numbers.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "dynamics/joined.h"
#include "fem/compile.h"
#include "model/words.h"
#include "response/reduction.h"
#include "response/soil_family.h"
#include "response/time_choice.h"
#include "run/derived.h"
#include "run/monitors.h"
#include "run/sliding/slip_ahead.h"
#include "run/soil_member.h"
#include "system/part.h"
#include "upbead/base/error.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

/// By how much both routes to F_T of yielding soil may differ, over the largest force: that is what its solves leave.
double tolerable_of_yielding(double tolerance) {
  return 1e-7 + 100. * yielding_tolerance * tolerance;
}

constexpr double most_steps = 1e6, most_fields = 1e4, most_dense = 1e6;

std::size_t n_kinks(const Scene& scene) {
  std::size_t n = 0;
  for (const auto& [name, load] : scene.loads) n += load.history.kinks().size();
  return n;
}

/// Per independent load, where the case asks for a reduced model: twice as many as where a march would do as well.
constexpr int most_vectors_by_name = 200;

/// Times (s) at which fields are written, other than t = 0.
std::vector<double> times_of_fields(const Scene& scene) {
  if (!scene.fields_every) return {};
  std::vector<double> times = scene.output_times;
  for (int i = 1; i * *scene.fields_every < scene.time.end; ++i) times.push_back(i * *scene.fields_every);
  return times;
}

/// Kinks of the loads, and the times of fields and of readings that the case lists, ascending.
std::vector<double> times_to_meet(const Scene& scene, const System& system) {
  std::vector<double> times = kinks(system);
  const std::vector<double> others = scene.fields_every ? times_of_fields(scene) : scene.output_times;
  times.insert(times.end(), others.begin(), others.end());
  std::sort(times.begin(), times.end());
  return times;
}

double largest_step(const TimeGrid& grid) {
  double step = 0.;
  for (const TimeSegment& segment : grid.segments) step = std::max(step, segment.step);
  return step;
}

Discretisation discretisation(const Simulation& simulation, const std::string& scheme, const Response& response) {
  Discretisation d;
  d.cells = static_cast<int>(simulation.mesh()->triangulation.n_active_cells());
  d.unknowns = simulation.unknowns()->n_free();
  d.processes = simulation.processes() ? simulation.processes()->count() : 1;
  d.degree = simulation.space()->degree();
  d.scheme = scheme;
  const std::vector<double>& time = response.ends.time;
  for (std::size_t n = 1; n < time.size(); ++n) d.time_step = std::max(d.time_step, time[n] - time[n - 1]);
  d.steps = response.n_steps;
  d.solves = response.n_solves;
  d.factorisations = response.n_factorisations;
  d.stopped_early = response.stopped_early;
  return d;
}

/// How the response was found.
Solution solution_of(const Simulation& simulation, const std::string& scheme, Response response) {
  Solution solution;
  solution.discretisation = discretisation(simulation, scheme, response);
  solution.response = std::move(response);
  solution.timing = simulation.timing();
  return solution;
}

std::string reasons(const Ladder& ladder) {
  if (ladder.size() == 1) return ladder.front().refused;
  std::string text = "no way to solve this scene holds:";
  for (const LadderStep& step : ladder) text += "\n  " + step.way + ": " + step.refused;
  return text;
}

/// Indices of the times at which some observer wants to see a state; none twice.
std::vector<Eigen::Index> wanted(const std::vector<double>& time, const std::vector<MarchObserver*>& observers) {
  std::vector<Eigen::Index> list;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (std::any_of(observers.begin(), observers.end(), [&](const MarchObserver* o) { return o->wants(time[i]); }))
      list.push_back(static_cast<Eigen::Index>(i));
  return list;
}

/// Shows observers the states that they want, as a march would have.
void show(const StateModel& states, const SampledLoads& loads, const std::vector<MarchObserver*>& observers,
          const std::function<void(double)>& progress) {
  const std::vector<Eigen::Index> times = wanted(loads.time, observers);
  if (times.empty()) return;
  const int n_steps = static_cast<int>(loads.time.size()) - 1;
  for_each_state(states, respond_in_coordinates(states.model, loads), times, [&](const State& state, Eigen::Index i) {
    for (MarchObserver* observer : observers)
      if (observer->wants(state.time)) observer->see(state, static_cast<int>(i), n_steps);
    if (progress) progress(static_cast<double>(i) / n_steps);
  });
}

/// Afterwards no other thread reads the mesh.
Reduction reduced(const Simulation& simulation, SlipAhead* ahead, const ReductionTargets& targets,
                  const std::function<void(double)>& progress) {
  const MeshLeft left{ahead};
  if (const SoilMember* member = simulation.member().get())
    return reduce_scene(simulation.scene(), member->compiled, targets, progress, member->room.get());
  return reduce_scene(simulation.scene(), *simulation.compiled(), targets, progress, simulation.room().get());
}

/// Reduces the scene and computes its response to its own loads. A case that asks for a reduced model gets one whose
/// F_T meets the tolerance; it lists readings that do not meet theirs. Throws NumericsError where it does
/// not converge.
Solution run_reduced(const Simulation& simulation, const SchemeChoice& choice, SlipAhead* ahead,
                     const Marching& marching) {
  const Stopwatch watch;
  const Scene& scene = simulation.scene();
  const System& system = simulation.system();
  const SampledLoads shown = sampled_loads(scene, system, times_of_fields(simulation.scene()));
  const bool is_shown = !wanted(shown.time, marching.observers).empty();
  // by what the scene asks for, not by who looks: a study, which shows no fields, must find what a run finds
  const bool everywhere = !simulation.member();
  const bool states = everywhere && (simulation.scene().fields_every || is_shown || has_strength(simulation.scene()) ||
                                     builds_pressure(simulation.scene()));
  const bool by_name = simulation.scene().time.scheme == TimeScheme::reduced;
  const std::optional<int> most_vectors = by_name ? most_vectors_by_name : choice.most_vectors;
  const std::optional<int> first_vectors = everywhere ? std::nullopt : std::optional(first_of_member);
  const double reducing_ends = is_shown ? 0.3 : 1.;  // 100 files take longer than the model
  // with a mesh made for the tolerance F_T has only a part of it, but other readings do not
  const ReductionTargets targets{false,        false, most_vectors, true, states, true, whole_tolerance(simulation),
                                 first_vectors};
  Reduction reduction = reduced(simulation, ahead, targets, part_of(marching.beside, 0., reducing_ends));
  if (by_name)
    require_shear_converged(reduction);
  else
    require_converged(reduction);
  Solution solution = solution_of(simulation, "reduced", respond(reduction, scene, system));
  solution.discretisation.why_scheme = choice.reason;
  solution.discretisation.why_step = simulation.scene().time.step ? "given in the case, or shorter where loads need it"
                                                                  : "a 32nd of the shortest load, for the record";
  solution.reduction = summary_of(reduction);
  if (simulation.member()) solution.reduction->error_of_soils = simulation.member()->error;
  solution.n_spared = reduction.n_spared;
  solution.model = std::move(reduction.model);
  solution.pressures = std::move(reduction.pressures);
  if (solution.pressures) solution.pressures->basis = joined(system, std::move(solution.pressures->basis));
  if (solution.pressures && simulation.member())
    solution.pressures->basis = in_scene(solution.pressures->basis, *simulation.member()->phi);
  solution.states = std::move(reduction.states);
  if (solution.states) show(*solution.states, shown, marching.observers, part_of(marching.beside, reducing_ends, 1.));
  solution.timing.factorise = reduction.factorise_seconds;
  solution.timing.march = watch.seconds() - solution.timing.factorise;
  return solution;
}

/// Marches; `choice` must be a scheme that marches, the observers see every step.
Solution run_march(const Simulation& simulation, const SchemeChoice& choice, const Marching& options, const Way& way) {
  SchemeOptions scheme_options;
  if (choice.scheme == TimeScheme::generalised_alpha) scheme_options.kind = SchemeKind::generalised_alpha;
  scheme_options.refined = way.refined;
  const std::unique_ptr<Scheme> scheme = make_scheme(simulation.system(), scheme_options);
  try {
    return march_by(*scheme, simulation, choice.reason, options, way.part);
  } catch (const InputError& error) {
    if (way.part == 1.) throw;  // the user did not ask for so many steps, so they are no mistake of the case
    throw NumericsError(error.diagnostics().list().front().what);
  }
}

/// The ways that a case allows. Where it leaves the scheme open: a reduced model, if that is less work, then `marched`
/// with more and more work; else the scheme that it names. A member of a family of soils is reduced alone.
std::vector<Way> ways(const Simulation& simulation, const SchemeChoice& choice, const SchemeChoice& marched) {
  const Scene& scene = simulation.scene();
  if (simulation.member() || scene.time.scheme == TimeScheme::reduced) return {{"reduced", false, 1., true}};
  std::vector<Way> list = ways_to_march(scene, word_of(marched.scheme, time_scheme_words));
  if (choice.scheme == TimeScheme::reduced) list.insert(list.begin(), {"reduced", false, 1., true});
  return list;
}

}  // namespace

std::string what_would_work(const Simulation& simulation, const std::function<void(double)>& progress) {
  const TimeScheme refused = simulation.scene().time.scheme;
  if (refused == TimeScheme::automatic) return "";
  Scene automatic = simulation.given();
  automatic.time.scheme = TimeScheme::automatic;
  const Simulation other = with_given(simulation, automatic);
  ObserverFunction reported = progress_observer(progress);
  Marching silent;
  silent.observers = {&reported};
  const SchemeChoice choice{TimeScheme::sdirk4, "another scheme was refused", {}};
  std::vector<Way> list = ways_to_march(other.scene(), word_of(choice.scheme, time_scheme_words));
  if (refused == TimeScheme::sdirk4) list.erase(list.begin(), list.begin() + 2);  // in its usual steps it was refused
  const auto solve = [&](const Way& way, const Marching& options) { return run_march(other, choice, options, way); };
  try {
    return "; time.scheme = \"auto\" answers this scene, by " + climb(other, list, silent, solve).ladder.back().way;
  } catch (const NumericsError&) {
    return "; nor does sdirk4 answer this scene, in steps a sixteenth as long either";
  }
}

Solution run_bonded(const Simulation& given, const Marching& marching) {
  const Simulation simulation = may_slip(given) ? with_room(given) : given;
  const SchemeChoice choice = simulation.member()
                                  ? SchemeChoice{TimeScheme::reduced, "one model answers all soils", most_of_member}
                                  : choose_scheme(simulation.scene(), *simulation.compiled());
  const bool reduces = choice.scheme == TimeScheme::reduced;
  const SchemeChoice marched = reduces ? SchemeChoice{TimeScheme::sdirk4, "the reduced model was refused", {}} : choice;
  const std::shared_ptr<SlipAhead> ahead = reduces ? slip_ahead(simulation) : nullptr;
  const auto solve = [&](const Way& way, const Marching& options) {
    const MeshLeft left{ahead.get()};  // also where nothing came to be reduced, before the next way goes through cells
    return way.reduced ? run_reduced(simulation, choice, ahead.get(), options)
                       : run_march(simulation, marched, options, way);
  };
  Solution solution = climb(simulation, ways(simulation, choice, marched), marching, solve);
  solution.simulation = std::make_shared<const Simulation>(simulation);
  solution.ahead = ahead;
  return solution;
}

void check_steps(const Scene& scene, double step, const std::optional<StepGrowth>& growth, const std::string& because) {
  const double end = scene.time.end, n = estimated_steps(n_kinks(scene), end, step, growth);
  if (n <= most_steps) return;
  const std::string what = " s makes about " + significant(n) + " steps, more than " + significant(most_steps);
  if (scene.time.step)
    throw InputError(at_key("time.step"),
                     "time.step = " + significant(step) + " s until time.end = " + significant(end) + what,
                     "raise time.step, or lower time.end");
  throw InputError(at_key("time.end"),
                   "time.end = " + significant(end) + " s in steps of " + significant(step) + what +
                       "; the step follows from " + because,
                   "lower time.end, or give time.step");
}

void check_size(const Scene& scene) {
  const double end = scene.time.end;
  if (scene.fields_every && end / *scene.fields_every > most_fields)
    throw InputError(at_key("output.fields.every"),
                     "every = " + significant(*scene.fields_every) + " s until time.end = " + significant(end) +
                         " s makes about " + significant(end / *scene.fields_every) + " fields, more than " +
                         significant(most_fields),
                     "raise every, or lower time.end");
  if (scene.output_every && end / *scene.output_every > most_dense)
    throw InputError(at_key("output.every"),
                     "every = " + significant(*scene.output_every) + " s until time.end = " + significant(end) +
                         " s makes about " + significant(end / *scene.output_every) +
                         " values of each history, more than " + significant(most_dense),
                     "raise every, or lower time.end");
  if (scene.time.step) return check_steps(scene, *scene.time.step, {}, "");
  const LoadStep loads = step_of_loads(scene, scene.time.scheme == TimeScheme::generalised_alpha ? 2 : 4);
  if (loads.lone_jump) return;
  const std::string load = loads.load.empty() ? "the loads" : "[loads." + loads.load + "]";
  check_steps(scene, loads.largest_step, loads.growth, load + ", which lasts " + significant(loads.duration) + " s");
}

ReductionSummary summary_of(const Reduction& r) {
  ReductionSummary summary;
  summary.vectors = r.n_vectors;
  summary.modes = r.model.n_modes();
  summary.error = r.error.history;
  summary.error_peak = r.error.peak;
  summary.error_of_others = r.error.others;
  if (r.states) summary.error_of_states = r.error.states;
  summary.highest_frequency = r.omega / two_pi;
  summary.inexact = inexact_readings(r);
  summary.tolerance_of_others = r.tolerance_of_others;
  return summary;
}

std::optional<Mismatch> imbalance(const Simulation& simulation, const Solution& solution) {
  const std::vector<EnergyAccount>& energy = solution.response.energy;
  try {
    if (simulation.compiled()->caisson)
      require_balance(reaction_mismatch(*simulation.compiled(), solution.response),
                      energy.empty() ? EnergyAccount() : energy.back(),
                      solution.yielding ? tolerable_of_yielding(whole_tolerance(simulation)) : 1e-7);
    else if (!energy.empty())
      require_balance(energy.back(), simulation.system(), simulation.scene().time.end);
  } catch (const Imbalance& found) {
    return found.mismatch();
  }
  return std::nullopt;
}

std::vector<Way> ways_to_march(const Scene& given, const std::string& scheme) {
  const std::string refined = scheme + ", refined solutions";
  std::vector<Way> list{{scheme}, {refined, true}};
  if (given.time.scheme != TimeScheme::automatic) return list;
  // Refined solutions cost twice as much, a quarter of the step costs four times: with it the error of sdirk4 falls by
  // a factor of 256. More than 32 times the work is never done.
  for (const double part : {0.25, 0.0625})
    list.push_back({refined + ", steps divided by " + significant(1. / part), true, part});
  return list;
}

Solution climb(const Simulation& simulation, const std::vector<Way>& ways, const Marching& marching,
               const std::function<Solution(const Way&, const Marching&)>& solve) {
  Ladder ladder;
  std::optional<Solution> closest;  // of those that do not balance
  double error_of_closest = infinity;
  Marching again = marching;
  again.checkpoints = {};
  for (const Way& way : ways) {
    ladder.push_back({way.name, ""});
    try {
      Solution solution = solve(way, way.refined ? again : marching);
      const std::optional<Mismatch> off = imbalance(simulation, solution);
      if (!off) {
        solution.ladder = std::move(ladder);
        return solution;
      }
      ladder.back().refused = Imbalance(*off).what();
      if (!off->bearable || !(off->error < error_of_closest)) continue;
      error_of_closest = off->error;
      solution.ladder = {{way.name + ", the closest of these", ""}};
      closest = std::move(solution);
    } catch (const NumericsError& error) {
      ladder.back().refused = error.what();
    }
  }
  if (!closest) throw NumericsError(reasons(ladder) + "; nothing was written, as such an answer is not to be trusted");
  closest->ladder.insert(closest->ladder.begin(), ladder.begin(), ladder.end());
  return std::move(*closest);
}

namespace {

/// Time at the end of the first n steps of a grid (s).
double time_after(const TimeGrid& grid, int n) {
  for (const TimeSegment& segment : grid.segments) {
    if (n <= segment.n_steps) return segment.start + n * segment.step;
    n -= segment.n_steps;
  }
  return infinity;
}

/// The grid of a march that goes on from a checkpoint: the same one where its steps meet the checkpoint. Where they do
/// not, as after a change of the end, steps begin anew there; the first segment stands for those that are done.
TimeGrid resumed(TimeGrid grid, const Response& so_far, std::vector<double> kinks, double largest_step,
                 std::optional<StepGrowth> growth) {
  const double reached = so_far.final_state.time, end = grid.end;
  if (so_far.n_steps == 0 || std::abs(time_after(grid, so_far.n_steps) - reached) <= 1e-9 * end) return grid;
  TimeGrid whole;
  whole.end = end;
  whole.segments.push_back({0., reached / so_far.n_steps, so_far.n_steps});
  if (!(reached < end * (1. - 1e-9))) return whole;
  for (double& kink : kinks) kink -= reached;
  if (growth) growth->after = std::max(0., growth->after - reached);
  for (TimeSegment segment : make_time_grid(std::move(kinks), end - reached, largest_step, growth).segments) {
    segment.start += reached;
    whole.segments.push_back(segment);
  }
  return whole;
}

/// Shows an observer of all unknowns the states of a caisson that may slip and is bonded for now.
class WithoutSlip : public MarchObserver {
 public:
  WithoutSlip(MarchObserver& observer, int n_unknowns) : observer_(observer), none_(Vector::Zero(n_unknowns)) {}
  void see(const State& state, int step, int n_steps) override {
    State whole = state;
    for (Vector* part : {&whole.x, &whole.v, &whole.a}) part->conservativeResizeLike(none_);
    observer_.see(whole, step, n_steps);
  }
  bool wants(double time) const override { return observer_.wants(time); }

 private:
  MarchObserver& observer_;
  Vector none_;
};

/// Whether a march is resumed that several processes have begun.
bool was_shared(const Checkpointing& checkpoints) {
  return checkpoints.resume_from && checkpoints.resume_from->observed.empty();
}

}  // namespace

Solution march_by(Scheme& scheme, const Simulation& simulation, const std::string& reason, const Marching& options,
                  double part, const System* in_place, KnownPeriods* known) {
  MarchOptions marching = options;
  const auto monitors =
      options.monitored ? std::make_shared<Monitors>(simulation, was_shared(options.checkpoints)) : nullptr;
  const System& system = in_place != nullptr ? *in_place : simulation.system();
  std::list<WithoutSlip> bonded;
  if (monitors) {
    std::vector<MarchObserver*> first = monitors->observers();
    const int n_unknowns = simulation.unknowns()->size();
    for (MarchObserver*& observer : first)
      if (n_unknowns > whole_size(system)) observer = &bonded.emplace_back(*observer, n_unknowns);
    marching.observers.insert(marching.observers.begin(), first.begin(), first.end());
  }
  const TimeChoice& time = simulation.scene().time;
  StepChoice step;
  step.largest_step = time.step.value_or(0.);
  step.reason = "given in the case";
  if (!time.step) {
    Scene whole = simulation.scene();
    whole.tolerance = whole_tolerance(simulation);
    step = choose_step(whole, *simulation.compiled(), scheme.order(), known);
    if (scheme.yielding() || scheme.contact()) step.largest_step *= contact_step;
    if (scheme.contact() && !scheme.yielding()) {
      marching.leap = contact_leap(whole_tolerance(simulation));
      step.reason += ", up to " + std::to_string(marching.leap) + " at once while no node moves";
    }
  }
  if (part < 1.) {
    step.largest_step *= part;
    if (step.growth) step.growth->largest *= part;
    step.reason = significant(part) + " of those of: " + step.reason;
  }
  if (!time.step || part < 1.) check_steps(simulation.scene(), step.largest_step, step.growth, step.reason);
  const std::vector<double> meeting = times_to_meet(simulation.scene(), system);
  TimeGrid grid = make_time_grid(meeting, time.end, step.largest_step, step.growth);
  if (const auto& from = options.checkpoints.resume_from)
    grid = resumed(std::move(grid), from->so_far, meeting, step.largest_step, step.growth);

  const Stopwatch watch;
  Response response = march(system, scheme, grid, marching);
  response.n_factorisations += step.factorisations;
  response.n_solves += step.factorisations;
  Solution solution = solution_of(simulation, scheme.name(), std::move(response));
  solution.monitors = monitors;
  solution.timing.factorise = scheme.factorise_seconds() + step.seconds;
  solution.timing.march = watch.seconds() - scheme.factorise_seconds();
  solution.discretisation.why_scheme = reason;
  solution.discretisation.why_step = step.reason;
  if (marching.leap > 1) solution.discretisation.time_step = largest_step(grid);
  return solution;
}

}  // namespace upbead
