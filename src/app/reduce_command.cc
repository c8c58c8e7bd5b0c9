#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "solve.h"
#include "upbead/app/commands.h"
#include "upbead/app/equivalent_linear.h"
#include "upbead/app/pipeline.h"
#include "upbead/base/error.h"
#include "upbead/base/files.h"
#include "upbead/base/interrupt.h"
#include "upbead/base/progress.h"
#include "upbead/base/stopwatch.h"
#include "upbead/base/text.h"
#include "upbead/model/words.h"
#include "upbead/output/model_file.h"
#include "upbead/response/reduction.h"
#include "upbead/response/shear_response.h"

namespace upbead {

namespace {

struct ReduceOptionsOfCommand : CommonOptions {
  bool all_readings = false;
  bool check = false;
};

/// Of the loads of a scene, by the names that the reduced model has for them.
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
    list.push_back({name, load.kind == LoadKind::force ? "N/m" : "Pa", std::max(up, -down),
                    std::isfinite(duration) ? duration : scene.time.end});
  }
  return list;
}

/// A load that prescribes a pore pressure is two loads of the system, with one history.
void join_pore_pressures(ModalModel& model) {
  const std::string suffix = ".pore_pressure";
  for (int k = model.n_loads() - 1; k > 0; --k) {
    const std::string& name = model.load_name[static_cast<std::size_t>(k)];
    const std::string& before = model.load_name[static_cast<std::size_t>(k - 1)];
    if (name == before + suffix) model.join_loads(k - 1, k);
  }
}

ModelSliding model_sliding(const SlidingChoice& choice, double peak_force) {
  ModelSliding sliding{choice.friction, choice.buoyant_weight, choice.drag};
  if (!choice.uplift) return sliding;
  const UpliftChoice& uplift = *choice.uplift;
  sliding.uplift = uplift.kind == UpliftKind::computed ? "computed"
                   : uplift.peak                       ? word_of(uplift.course, uplift_course_words)
                                                       : "history";
  if (uplift.peak && peak_force > 0.) sliding.uplift_per_force = *uplift.peak / peak_force;
  sliding.lag = uplift.lag;
  return sliding;
}

ReducedModelFile model_of(const Case& input, const CompiledCase& scene, Reduction reduction,
                          const std::string& folder) {
  ReducedModelFile file;
  file.title = input.scene.title;
  file.case_text = effective_case(input, folder);
  file.modes = std::move(reduction.model);
  join_pore_pressures(file.modes);
  file.loads = model_loads(input.scene, file.modes);
  file.caisson_mass = scene.compiled.caisson ? scene.compiled.caisson->body.mass : 0.;
  file.end = input.scene.time.end;
  if (const auto& sliding = input.scene.sliding)
    file.sliding = model_sliding(*sliding, extremum(force_on_caisson(scene.compiled), 0., file.end, 1).value);
  file.highest_frequency = summary_of(reduction).highest_frequency;
  file.tolerance = input.scene.tolerance;
  file.error = reduction.error.history;
  file.error_peak = reduction.error.peak;
  file.unknowns = scene.compiled.system.n_free();
  file.solves = reduction.n_solves;
  file.factorisations = 1;
  return file;
}

std::string to_json(const ReducedModelFile& m, const Reduction& r, const std::string& path, const Timing& t) {
  nlohmann::ordered_json json = {{"title", m.title}, {"model", path}};
  json["discretisation"] = {{"unknowns", m.unknowns}, {"solves", m.solves}, {"factorisations", m.factorisations}};
  json["reduction"] = {{"vectors", r.n_vectors},
                       {"modes", m.modes.n_modes()},
                       {"independent_loads", r.n_independent_loads},
                       {"error", m.error},
                       {"error_peak", m.error_peak},
                       {"error_of_others", r.error.others},
                       {"highest_frequency", m.highest_frequency}};
  json["reduction"]["error_march"] = m.error_march ? nlohmann::ordered_json(*m.error_march) : nullptr;
  json["timing"] = {
      {"mesh", t.mesh}, {"compile", t.compile}, {"factorise", t.factorise}, {"reduce", t.march}, {"total", t.total}};
  return json.dump(2) + "\n";
}

std::string describe(const ReducedModelFile& m, const Reduction& r, const std::string& path, const Timing& t) {
  std::string text = m.title + "\n";
  text += "reduced     " + std::to_string(m.unknowns) + " unknowns to " + std::to_string(m.modes.n_modes()) +
          " modes, by 1 factorisation and " + std::to_string(m.solves) + " solves\n";
  text += "loads      ";
  for (const ModelLoad& load : m.loads) text += " " + load.name + " (" + load.unit + ")";
  text += "\nerror       history of F_T " + significant(m.error, 2) + " of its peak, its peak " +
          significant(m.error_peak, 2) + ", other readings up to " + significant(r.error.others, 2) +
          " of theirs (nested models)\n";
  if (m.error_march) text += "            history of F_T " + significant(*m.error_march, 2) + " against a march\n";
  text += "checked     up to " + significant(m.highest_frequency) + " Hz\n";
  text += "time        factorise " + significant(t.factorise, 2) + " s, reduce " + significant(t.march, 2) +
          " s, total " + significant(t.total, 2) + " s\n";
  return text + "written     " + path + "\n";
}

Reduction reduce_with_progress(const CompiledCase& scene, const ReductionAim& aim) {
  Progress progress("reducing");
  return reduce_scene(scene.scene, scene.compiled, aim, [&progress](double done) {
    check_interrupt();
    progress.update(done);
  });
}

void reduce(const ReduceOptionsOfCommand& options, const Stopwatch& since_start) {
  const Case input = read_case(options.file, options.overrides);
  require_loads(input);
  note_interrupts();
  OutputFolder folder(options.out.empty() ? "results/" + input.stem : options.out);
  CompiledCase scene = compile_case(input);
  if (!scene.compiled.caisson)
    throw InputError(input.place("mesh"), "the mesh has no surface 'caisson': there is no F_T to reduce the scene to",
                     "use 'upbead run'");
  if (!input.scene.time.inertia)
    throw InputError(input.place("time.inertia"), "consolidation cannot be reduced: inertia = false",
                     "use 'upbead run'");
  {
    Progress progress("settling the soil");
    settle_soil(input, scene, [&progress](double done) {
      check_interrupt();
      progress.update(done);
    });
  }
  const Stopwatch watch;
  const Reduction reduction = reduce_with_progress(scene, {!options.all_readings, true, {}});
  require_converged(reduction);
  Timing timing = scene.timing;
  timing.factorise = reduction.factorise_seconds;
  timing.march = watch.seconds() - reduction.factorise_seconds;
  check_interrupt();
  ReducedModelFile model = model_of(input, scene, reduction, folder.name());
  if (options.check) model.error_march = error_against_march(reduction, scene.scene, scene.compiled);
  folder.write("reduced.h5", model_file(model));
  check_interrupt();
  folder.commit();
  timing.total = since_start.seconds();
  const std::string path = folder.name() + "/reduced.h5";
  std::cout << (options.json ? to_json(model, reduction, path, timing) : describe(model, reduction, path, timing));
}

}  // namespace

void add_reduce(CLI::App& program) {
  auto options = std::make_shared<ReduceOptionsOfCommand>();
  CLI::App* command = program.add_subcommand("reduce", "solve a scene once for all waves: write its reduced model");
  add_common_options(*command, *options);
  command->add_flag("--all-readings", options->all_readings,
                    "go on until all readings, not F_T alone, move by less than ten times the tolerance");
  command->add_flag("--check", options->check, "march the case as well and tell the error against that; takes longer");
  command->footer(
      "Writes results/NAME/reduced.h5 (or into --out DIR): the modes of the scene with their error and validity, "
      "which\n"
      "'upbead respond' and postprocess/reduced_model.py apply to any wave. The model is as large as the case's\n"
      "[accuracy] tolerance asks for, measured on the case's own histories by nested models.\n\n"
      "Examples:\n"
      "  upbead reduce cases/fig2b-prototype.toml\n"
      "  upbead reduce cases/fig2b-prototype.toml --check --set accuracy.tolerance=0.001 --out /tmp/fine\n"
      "  upbead respond results/fig2b-prototype/reduced.h5 cases/fig2b-prototype-impulse.csv");
  command->callback([options, since_start = Stopwatch()] { reduce(*options, since_start); });
}

}  // namespace upbead
