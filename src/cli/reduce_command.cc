#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "case/case_run.h"
#include "case/input_files.h"
#include "case/script_trust.h"
#include "cli/command.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/effective_base.h"
#include "model/exclusions.h"
#include "model/words.h"
#include "respond/respond_slip.h"
#include "response/reduction.h"
#include "response/shear_response.h"
#include "run/sliding/coupled_sliding.h"
#include "run/sliding/uplift.h"
#include "run/solve.h"
#include "system/interface.h"
#include "upbead/base/error.h"
#include "upbead/output/model_file.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

/// The loads of a scene under the names that they have in the reduced model.
std::vector<ModelLoad> model_loads(const Scene& scene, const ModalModel& model) {
  std::vector<ModelLoad> list;
  for (const std::string& name : model.load_name) {
    const Load& load = scene.loads.at(name);
    Scene alone;
    alone.time = scene.time;
    alone.loads[name] = load;
    const double up = extremum(load.history, 0., scene.time.end, 1).value;
    const double down = extremum(load.history, 0., scene.time.end, -1).value;
    const double duration = shortest_duration(alone);
    list.push_back(
        {name, unit_of(load.kind), std::max(up, -down), std::isfinite(duration) ? duration : scene.time.end});
  }
  return list;
}

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
  const System& system = simulation.compiled()->system;
  const Series none{{}, Eigen::MatrixXd(system.readings.size(), 0), Eigen::MatrixXd(system.loads.size(), 0)};
  const std::optional<EffectiveBase> base = effective_base(simulation, none);
  if (!base) return std::nullopt;
  ModelBase told{base->width, base->weight, base->weight_moment, 0.};
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
  file.loads = model_loads(input.scene, file.modes);
  file.caisson_mass = simulation.compiled()->caisson ? simulation.compiled()->caisson->body.mass : 0.;
  file.end = input.scene.time.end;
  if (const auto& sliding = input.scene.sliding)
    file.sliding = model_sliding(*sliding, extremum(force_on_caisson(*simulation.compiled()), 0., file.end, 1).value);
  file.base = model_base(simulation);
  file.highest_frequency = summary_of(reduction).highest_frequency;
  file.tolerance = input.scene.tolerance;
  file.error = reduction.error.history;
  file.error_peak = reduction.error.peak;
  file.unknowns = simulation.compiled()->system.n_free();
  file.solves = reduction.n_solves;
  file.factorisations = 1;
  return file;
}

nlohmann::ordered_json to_object(const ReducedSlip& slip) {
  if (!slip.model) return nullptr;
  return {{"vectors", slip.model->vectors},
          {"solves", slip.model->solves},
          {"error", slip.model->error},
          {"glued_error", slip.model->glued_error},
          {"time", slip.seconds}};
}

/// Shows the progress, and ends the work where the user interrupts.
std::function<void(double)> watched(Progress& progress) {
  return [&progress](double done) {
    check_interrupt();
    progress.update(done);
  };
}

/// Larger models of the same loads, which estimate the error for any wave.
struct Nested {
  std::optional<NestedModels> models;
  std::string why_not;
  double seconds = 0.;
};

/// No models where the scene allows no larger ones; the model itself is as good without them.
Nested nest(const Simulation& simulation, const Reduction& reduction) {
  Progress progress("reducing further");
  const Stopwatch watch;
  const System& system = simulation.compiled()->system;
  const NestedSpace space{krylov_shift(simulation.scene()), reduction.n_vectors,
                          simulation.compiled()->body_coordinates};
  Nested nested;
  try {
    nested.models = nested_models(system, space, {system.reading(reading::shear_force)}, watched(progress));
    for (ModalModel* model : {&nested.models->middle, &nested.models->reference}) join_pore_pressures(*model);
  } catch (const NumericsError& error) {
    nested.models.reset();
    nested.why_not = error.what();
  }
  nested.seconds = watch.seconds();
  return nested;
}

nlohmann::ordered_json to_object(const Nested& nested) {
  if (!nested.models) return nullptr;
  const NestedModels& m = *nested.models;
  return {{"modes", {m.middle.n_modes(), m.reference.n_modes()}},
          {"solves", m.solves},
          {"factorisations", m.factorisations},
          {"time", nested.seconds}};
}

std::string describe(const Nested& nested) {
  if (!nested.models) return "";
  const NestedModels& m = *nested.models;
  return "waves       their errors by larger models of " + std::to_string(m.middle.n_modes()) + " and " +
         std::to_string(m.reference.n_modes()) + " modes, " + std::to_string(m.solves) + " solves, " +
         significant(nested.seconds, 2) + " s\n";
}

/// All results of `reduce` for a case.
struct Reduced {
  ReducedModelFile file;
  Reduction reduction;
  ReducedSlip slip;
  std::vector<Skipped> skipped;
  Nested nested;
  std::string path;
  Timing timing;
};

std::string to_json(const Reduced& made) {
  const ReducedModelFile& m = made.file;
  const Reduction& r = made.reduction;
  const Timing& t = made.timing;
  nlohmann::ordered_json json = {{"title", m.title}, {"model", made.path}};
  json["discretisation"] = {{"unknowns", m.unknowns}, {"solves", m.solves}, {"factorisations", m.factorisations}};
  json["reduction"] = {{"vectors", r.n_vectors},
                       {"modes", m.modes.n_modes()},
                       {"independent_loads", r.n_independent_loads},
                       {"error", m.error},
                       {"error_peak", m.error_peak},
                       {"error_of_others", r.error.others},
                       {"highest_frequency", m.highest_frequency}};
  json["reduction"]["error_march"] = m.error_march ? nlohmann::ordered_json(*m.error_march) : nullptr;
  json["nested"] = to_object(made.nested);
  json["slip"] = to_object(made.slip);
  json["skipped"] = nlohmann::ordered_json::array();
  for (const Skipped& part : made.skipped) json["skipped"].push_back({{"what", part.what}, {"why", part.why}});
  json["timing"] = {
      {"mesh", t.mesh}, {"compile", t.compile}, {"factorise", t.factorise}, {"reduce", t.march}, {"total", t.total}};
  return json.dump(2) + "\n";
}

std::string describe(const ReducedSlip& slip) {
  if (!slip.model) return "";
  return "slip        of the caisson with its ground, " + std::to_string(slip.model->vectors) + " vectors, " +
         std::to_string(slip.model->solves) + " solves, " + significant(slip.seconds, 2) + " s; its forces " +
         significant(slip.model->error, 2) + " of their peaks (nested models), F_T while it sticks " +
         significant(slip.model->glued_error, 2) + " (against the model without slip)\n";
}

std::string describe(const Reduced& made) {
  const ReducedModelFile& m = made.file;
  const Reduction& r = made.reduction;
  const Timing& t = made.timing;
  std::string text = m.title + "\n";
  text += "reduced     " + std::to_string(m.unknowns) + " unknowns to " + std::to_string(m.modes.n_modes()) +
          " modes, by 1 factorisation and " + std::to_string(m.solves) + " solves\n";
  text += "loads      ";
  for (const ModelLoad& load : m.loads) text += " " + load.name + " (" + load.unit + ")";
  text += "\nerror       history of F_T " + significant(m.error, 2) + " of its peak, its peak " +
          significant(m.error_peak, 2) + ", other readings up to " + significant(r.error.others, 2) +
          " of their own largest value (by nested models)\n";
  if (m.error_march) text += "            history of F_T " + significant(*m.error_march, 2) + " against a march\n";
  text += describe(made.nested);
  text += "checked     up to " + significant(m.highest_frequency) + " Hz\n" + describe(made.slip);
  for (const Skipped& part : made.skipped) text += "skipped     " + part.what + ": " + part.why + "\n";
  text += "time        factorise " + significant(t.factorise, 2) + " s, reduce " + significant(t.march, 2) +
          " s, total " + significant(t.total, 2) + " s\n";
  return text + "written     " + made.path + "\n";
}

/// The case as it is reduced: soil that depends on its strain is converged, the caisson is bonded to its ground.
Simulation simulation_for_waves(Case& input) {
  const Simulation simulation = simulation_of(input, settle_end(input));
  if (!simulation.compiled()->caisson)
    throw InputError(input.place("mesh"), "the mesh has no surface 'caisson': there is no F_T to reduce the scene to",
                     "use 'upbead run'");
  for (const Exclusion& reason : excluded(input.scene, Treatment::reduce_command))
    throw InputError(input.place(reason.key), reason.why, "use 'upbead run'");
  Progress progress("soil and strain");
  return in_places_of(input, [&] { return bonded(with_converged_soil(simulation, watched(progress))); });
}

/// What the model of a case leaves out, in the words of a run.
std::vector<Skipped> skipped(const Simulation& simulation, const ReducedSlip& slip, const Nested& nested) {
  std::vector<Skipped> list;
  if (!nested.why_not.empty()) list.push_back({"the error of each wave (error_estimate is null)", nested.why_not});
  if (!slip.why_not.empty()) list.push_back({"slip of the caisson with its ground", slip.why_not});
  if (simulation.with_interface())
    list.push_back({"contact node by node", "a reduced model has none; 'upbead run' follows it"});
  return list;
}

Reduction reduce_bonded(const Simulation& simulation, bool all_readings) {
  Progress progress("reducing");
  Reduction reduction =
      reduce_scene(simulation.scene(), *simulation.compiled(), {!all_readings, true, {}}, watched(progress));
  require_converged(reduction);
  return reduction;
}

int reduce(const CaseOptions& options, const Stopwatch& since_start) {
  Case input = read_case(options.file, options.overrides);
  require_trust(input, options.trusted);
  require_loads(input);
  std::cerr << notes_on(input);
  note_interrupts();
  const std::string out = options.out.empty() ? "results/" + input.stem : options.out;
  require_inputs_kept(out, {"reduced.h5"}, input_files(input));
  OutputFolder folder(out);
  const Simulation simulation = simulation_for_waves(input);
  const Stopwatch watch;
  Reduced made;
  made.reduction = reduce_bonded(simulation, options.all_readings);
  made.timing = simulation.timing();
  made.timing.factorise = made.reduction.factorise_seconds;
  made.timing.march = watch.seconds() - made.reduction.factorise_seconds;
  made.nested = nest(simulation, made.reduction);
  {
    Progress progress("reducing with slip");
    made.slip = reduce_with_slip(simulation, made.reduction, watched(progress));
  }
  made.skipped = skipped(simulation, made.slip, made.nested);
  check_interrupt();
  made.file = model_of(input, simulation, made.reduction, folder.name());
  made.file.slip = made.slip.model;
  made.file.nested = made.nested.models;
  if (options.check)
    made.file.error_march = error_against_march(made.reduction, simulation.scene(), *simulation.compiled());
  folder.write("reduced.h5", model_file(made.file));
  check_interrupt();
  folder.commit();
  made.timing.total = since_start.seconds();
  made.path = folder.name() + "/reduced.h5";
  std::cout << (options.json ? to_json(made) : describe(made));
  return 0;
}

}  // namespace

Command reduce_command() {
  const auto options = std::make_shared<CaseOptions>();
  Command command = case_command("reduce", *options);
  command.work = [options, since_start = Stopwatch()] { return reduce(*options, since_start); };
  return command;
}

}  // namespace upbead
