#include "cli/reduced_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/interrupt.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "case/case_run.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/circle_ground.h"
#include "findings/effective_base.h"
#include "findings/finding.h"
#include "model/exclusions.h"
#include "model/words.h"
#include "respond/respond_warnings.h"
#include "response/shear_response.h"
#include "run/derived.h"
#include "run/sliding/slip_ahead.h"
#include "run/sliding/uplift.h"
#include "run/solve.h"
#include "system/interface.h"
#include "upbead/base/error.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

/// The loads of a scene under the names that they have in the reduced model.
std::vector<ModelLoad> model_loads(const Scene& scene, const CompiledScene& compiled, const ModalModel& model) {
  std::vector<ModelLoad> list;
  const std::vector<SystemLoad>& loads = compiled.system.loads;
  for (const std::string& name : model.load_name) {
    const Load& load = scene.loads.at(name);
    Scene alone;
    alone.time = scene.time;
    alone.loads[name] = load;
    const double up = extremum(load.history, 0., scene.time.end, 1).value;
    const double down = extremum(load.history, 0., scene.time.end, -1).value;
    const double duration = shortest_duration(alone);
    const auto own =
        std::find_if(loads.begin(), loads.end(), [&name](const SystemLoad& one) { return one.name == name; });
    list.push_back({name, unit_of(load.kind), std::max(up, -down), std::isfinite(duration) ? duration : scene.time.end,
                    compiled.loads_on_caisson.at(static_cast<std::size_t>(own - loads.begin())).moment});
  }
  return list;
}

/// `peak_force`: the largest landward P, or where it never is landward, seaward (N/m).
ModelSliding model_sliding(const SlidingChoice& choice, double peak_force) {
  ModelSliding sliding{choice.friction, choice.submerged_weight, choice.drag};
  if (!choice.uplift) return sliding;
  const UpliftChoice& uplift = *choice.uplift;
  sliding.uplift = uplift.kind == UpliftKind::computed ? "computed"
                   : uplift.peak                       ? word_of(uplift.course, uplift_course_words)
                                                       : "history";
  if (uplift.peak && peak_force > 0.) sliding.uplift_per_force = *uplift.peak / peak_force;
  sliding.lag = uplift.lag;
  return sliding;
}

/// The bottom of the caisson; none where W' is not known.
std::optional<ModelBase> model_base(const Simulation& simulation) {
  const System& system = simulation.system();
  const Series none{{}, Eigen::MatrixXd(system.readings.size(), 0), Eigen::MatrixXd(system.loads.size(), 0)};
  const std::optional<EffectiveBase> base = effective_base(simulation, none);
  if (!base) return std::nullopt;
  ModelBase told{base->width, base->weight, base->weight_moment, 0., base->push, base->push_moment};
  const std::vector<UpliftLoad> uplift = uplift_loads(simulation, {}, {});  // one where it has a peak, for `respond`
  if (uplift.size() == 1 && uplift.front().force > 0.)
    told.uplift_moment_per_force = uplift.front().moment / uplift.front().force;
  return told;
}

ReducedModelFile model_of(const Case& input, const Simulation& simulation, Reduction reduction,
                          const std::string& folder) {
  ReducedModelFile file;
  file.title = input.scene.title;
  file.case_text = effective_case(input, folder);
  file.modes = std::move(reduction.model);
  join_pore_pressures(file.modes);
  file.loads = model_loads(input.scene, *simulation.compiled(), file.modes);
  file.caisson_mass = simulation.compiled()->caisson ? simulation.compiled()->caisson->body.mass : 0.;
  file.end = input.scene.time.end;
  file.sliding = sliding_of_case(input.scene, simulation);
  file.base = model_base(simulation);
  if (input.scene.initial && input.scene.initial->harbour_level && simulation.compiled()->caisson) {
    file.still = still_water(simulation.scene(), *simulation.compiled()->caisson);
    if (file.sliding) {
      file.sliding->submerged_weight += file.still->weight;
      file.sliding->push = file.still->push;
    }
  }
  file.highest_frequency = summary_of(reduction).highest_frequency;
  file.tolerance = input.scene.tolerance;
  file.error = reduction.error.history;
  file.error_peak = reduction.error.peak;
  file.unknowns = simulation.system().n_free();
  file.solves = reduction.n_solves;
  file.factorisations = 1;
  return file;
}

/// Shows the progress, and ends the work where the user interrupts.
std::function<void(double)> shown_by(Progress& progress) {
  return [&progress](double done) {
    check_interrupt();
    progress.update(done);
  };
}

/// No models where the scene allows no larger ones; the model itself is as good without them.
Nested nest(const Simulation& simulation, const Reduction& reduction) {
  Progress progress("reducing further");
  const Stopwatch watch;
  const System& system = simulation.system();
  const NestedSpace space{krylov_shift(simulation.scene()), reduction.n_vectors,
                          simulation.compiled()->body_coordinates};
  Nested nested;
  try {
    nested.models = nested_models(system, space, {system.reading(reading::shear_force)}, shown_by(progress));
    for (ModalModel* model : {&nested.models->middle, &nested.models->reference}) join_pore_pressures(*model);
  } catch (const NumericsError& error) {
    nested.models.reset();
    nested.why_not = error.what();
  }
  nested.seconds = watch.seconds();
  return nested;
}

/// The case as it is reduced: soil that depends on its strain is converged, the caisson is bonded to its ground.
Simulation simulation_for_waves(const Case& input, const Simulation& simulation) {
  if (!simulation.compiled()->caisson)
    throw InputError(input.place("mesh"), "the mesh has no surface 'caisson': there is no F_T to reduce the scene to",
                     "use 'upbead run'");
  for (const Exclusion& reason : excluded(input.scene, Treatment::reduce_command))
    throw InputError(input.place(reason.key), reason.why, "use 'upbead run'");
  Progress progress("soil and strain");
  return in_places_of(input, [&] {
    const Simulation as_reduced = bonded(with_converged_soil(simulation, shown_by(progress)));
    return may_slip(as_reduced) ? with_room(as_reduced) : as_reduced;  // slip is reduced in the same basis
  });
}

/// What the model of a case leaves out, in the words of a run.
std::vector<Skipped> skipped(const Reduced& made) {
  std::vector<Skipped> list;
  const std::string &nested = made.nested.why_not, &slip = made.slip.why_not, &circles = made.circles.why_not;
  if (!nested.empty()) list.push_back({"the error of each wave (error_estimate is null)", nested});
  if (!slip.empty()) list.push_back({"slip of the caisson with its ground", slip});
  if (!circles.empty()) list.push_back({"slip circles under the caisson", circles});
  if (!made.contact.why_not.empty()) list.push_back({"contact node by node", made.contact.why_not});
  return list;
}

Reduction reduce_bonded(const Simulation& simulation, bool all_readings, bool circles) {
  Progress progress("reducing");
  ReductionTargets targets{!all_readings, true, {}};
  targets.pressures = circles;
  Reduction reduction =
      reduce_scene(simulation.scene(), *simulation.compiled(), targets, shown_by(progress), simulation.room().get());
  require_converged(reduction);
  return reduction;
}

CircleModelMade circles_of(const Simulation& simulation, const Reduction& reduction) {
  Progress progress("seeking slip circles");
  CircleModelMade made = circle_model(simulation, reduction);
  if (made.model) join_pore_pressures(made.model->pressures);
  return made;
}

/// Of the case before it is bonded. Loads that the bonded model names otherwise would be answered by others.
ContactModelMade contact_of(const Simulation& simulation, const Reduction& reduction) {
  Progress progress("reducing the ground of contact");
  ContactModelMade made = contact_model(simulation, shown_by(progress));
  ModalModel bonded = reduction.model;
  join_pore_pressures(bonded);
  if (made.model && made.model->demand.load_name != bonded.load_name)
    throw std::logic_error("the ground of contact has other loads than the bonded model");
  return made;
}

/// Whether a warning of a scene is of its own loads and concerns no other wave.
bool is_of_loads(const NumberedWarning& warning) {
  constexpr std::array names{"fast_load", "jump_with_alpha", "motion_stays", "step_too_coarse"};
  return std::find(names.begin(), names.end(), warning.name) != names.end() ||
         (warning.what.rfind("loads.", 0) == 0 && warning.what.find(".shape ") == std::string::npos) ||
         warning.what.rfind("the prescribed uplift follows P by", 0) == 0;
}

}  // namespace

NumberedWarnings Reduced::warnings() const {
  NumberedWarnings all = file.warnings;
  append(all, uplift_warnings(file));
  append(all, of_loads);
  return all;
}

std::optional<ModelSliding> sliding_of_case(const Scene& scene, const Simulation& simulation) {
  if (!scene.sliding) return std::nullopt;
  const TimeFunction P = force_on_caisson(*simulation.compiled());
  const double landward = extremum(P, 0., scene.time.end, 1).value;
  return model_sliding(*scene.sliding, landward > 0. ? landward : -extremum(P, 0., scene.time.end, -1).value);
}

WarningsOfCase warnings_of_case(const Case& input, const Simulation& simulation) {
  const NumberedWarnings of_scene = warnings(simulation);
  WarningsOfCase told;
  for (const NumberedWarning& warning : warnings(input, simulation)) {
    const bool in_scene = std::any_of(of_scene.begin(), of_scene.end(),
                                      [&](const NumberedWarning& other) { return other.what == warning.what; });
    (in_scene && !is_of_loads(warning) ? told.scene : told.loads).push_back(warning);
  }
  return told;
}

Reduced reduced_case(Case& input, const CaseModelOptions& options, const std::string& folder) {
  const Simulation simulation = simulation_of(input, settle_end(input));
  return reduced_case(input, simulation, options, folder);
}

Reduced reduced_case(const Case& input, const Simulation& of_case, const CaseModelOptions& options,
                     const std::string& folder) {
  const Simulation simulation = simulation_for_waves(input, of_case);
  const Stopwatch watch;
  Reduced made;
  const bool may_have_circles = !options.bare && why_no_circles_in(simulation).empty();
  made.reduction = reduce_bonded(simulation, options.all_readings, may_have_circles);
  made.timing = simulation.timing();
  made.timing.factorise = made.reduction.factorise_seconds;
  made.timing.march = watch.seconds() - made.reduction.factorise_seconds;
  if (!options.bare) made.nested = nest(simulation, made.reduction);
  if (!options.bare) {
    Progress progress("reducing with slip");
    made.slip = reduce_with_slip(simulation, made.reduction, shown_by(progress));
  }
  if (may_have_circles) made.circles = circles_of(simulation, made.reduction);
  if (!options.bare) made.contact = contact_of(of_case, made.reduction);
  made.skipped = skipped(made);
  check_interrupt();
  made.file = model_of(input, simulation, made.reduction, folder);
  made.file.slip = made.slip.model;
  made.file.nested = made.nested.models;
  made.file.circles = made.circles.model;
  made.file.contact = made.contact.model;
  WarningsOfCase told = warnings_of_case(input, of_case);
  made.file.warnings = std::move(told.scene);
  made.of_loads = std::move(told.loads);
  if (options.against_march)
    made.file.error_march = error_against_march(made.reduction, simulation.scene(), *simulation.compiled());
  return made;
}

}  // namespace upbead
