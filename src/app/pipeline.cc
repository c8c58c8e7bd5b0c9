#include "upbead/app/pipeline.h"

#include <algorithm>

#include "upbead/base/stopwatch.h"
#include "upbead/base/text.h"
#include "upbead/fem/scene_check.h"
#include "upbead/response/step_choice.h"

namespace upbead {

namespace {

void throw_objections(const Case& input, const std::vector<Objection>& objections) {
  Mistakes mistakes;
  for (const Objection& objection : objections)
    mistakes.add(input.place(objection.key), objection.what, objection.cure);
  mistakes.throw_if_any();
}

/// Kinks of the loads and the times at which fields are written.
std::vector<double> times_to_meet(const Scene& scene, const System& system) {
  std::vector<double> times = kinks(system);
  if (scene.fields_every)
    for (int i = 1; i * *scene.fields_every < scene.time.end; ++i) times.push_back(i * *scene.fields_every);
  std::sort(times.begin(), times.end());
  return times;
}

constexpr double most_steps = 1e6, most_fields = 1e4;

std::size_t n_kinks(const Scene& scene) {
  std::size_t n = 0;
  for (const auto& [name, load] : scene.loads) n += load.history.kinks().size();
  return n;
}

/// Throws where steps of that length are too many; `because` says what set a length that the case does not give.
void check_steps(const Case& input, double step, const std::optional<StepGrowth>& growth, const std::string& because) {
  const Scene& scene = input.scene;
  const double end = scene.time.end, n = estimated_steps(n_kinks(scene), end, step, growth);
  if (n <= most_steps) return;
  const std::string what = " s makes about " + significant(n) + " steps, more than " + significant(most_steps);
  if (scene.time.step)
    throw InputError(input.place("time.step"),
                     "time.step = " + significant(step) + " s until time.end = " + significant(end) + what,
                     "raise time.step, or lower time.end");
  throw InputError(input.place("time.end"),
                   "time.end = " + significant(end) + " s in steps of " + significant(step) + what +
                       "; the step follows from " + because,
                   "lower time.end, or give time.step");
}

int order_of(const Scene& scene) {
  return scene.time.scheme == TimeScheme::generalised_alpha ? 2 : 4;
}

SchemeOptions scheme_options(const Scene& scene) {
  SchemeOptions options;
  if (scene.time.scheme == TimeScheme::generalised_alpha) options.kind = SchemeKind::generalised_alpha;
  return options;
}

Discretisation discretisation(const CompiledCase& scene, const Scheme& scheme, const TimeGrid& grid,
                              const Response& response) {
  Discretisation d;
  d.cells = static_cast<int>(scene.mesh->triangulation.n_active_cells());
  d.unknowns = scene.compiled.system.n_free();
  d.degree = scene.space->degree();
  d.scheme = scheme.name();
  for (const TimeSegment& segment : grid.segments) d.time_step = std::max(d.time_step, segment.step);
  d.steps = response.n_steps;
  d.solves = scheme.n_solves();
  d.factorisations = scheme.n_factorisations();
  return d;
}

}  // namespace

void check_size(const Case& input) {
  const Scene& scene = input.scene;
  const double end = scene.time.end;
  if (scene.fields_every && end / *scene.fields_every > most_fields)
    throw InputError(input.place("output.fields.every"),
                     "every = " + significant(*scene.fields_every) + " s until time.end = " + significant(end) +
                         " s makes about " + significant(end / *scene.fields_every) + " fields, more than " +
                         significant(most_fields),
                     "raise every, or lower time.end");
  if (scene.time.step) return check_steps(input, *scene.time.step, {}, "");
  const LoadStep loads = step_of_loads(scene, order_of(scene));
  if (loads.lone_jump) return;
  const std::string load = loads.load.empty() ? "the loads" : "[loads." + loads.load + "]";
  check_steps(input, loads.largest_step, loads.growth, load + ", which lasts " + significant(loads.duration) + " s");
}

CompiledCase compile_case(const Case& input) {
  check_size(input);
  const Scene& scene = input.scene;
  CompiledCase out;
  const Stopwatch mesh_watch;
  out.mesh = read_mesh(mesh_request(input));
  throw_objections(input, check_scene(scene, *out.mesh));
  out.timing.mesh = mesh_watch.seconds();

  const Stopwatch compile_watch;
  ResolvedScene resolved = resolve(scene, *out.mesh);
  out.scene = std::move(resolved.scene);
  out.decisions = std::move(resolved.decisions);
  out.space = std::make_unique<Space>(*out.mesh, out.scene, resolved.absent);
  const std::vector<Body> bodies = rigid_bodies(*out.space);
  out.unknowns = std::make_unique<Unknowns>(*out.space, out.scene, bodies);
  out.compiled = compile(out.scene, *out.space, *out.unknowns, bodies);
  out.timing.compile = compile_watch.seconds();
  return out;
}

Run run_case(const Case& input, const CompiledCase& scene, const MarchOptions& options) {
  const System& system = scene.compiled.system;
  const TimeChoice& time = input.scene.time;
  Run run;
  Timing timing = scene.timing;
  const std::unique_ptr<Scheme> scheme = make_scheme(system, scheme_options(input.scene));
  double largest_step = time.step.value_or(0.);
  run.step_reason = "given in the case";
  StepChoice choice;
  if (!time.step) {
    choice = choose_step(input.scene, scene.compiled, scheme->order());
    largest_step = choice.largest_step;
    run.step_reason = choice.reason;
    check_steps(input, largest_step, choice.growth, choice.reason);
  }
  const TimeGrid grid = make_time_grid(times_to_meet(input.scene, system), time.end, largest_step, choice.growth);

  const Stopwatch march_watch;
  run.response = march(system, *scheme, grid, options);
  timing.factorise = scheme->factorise_seconds() + choice.seconds;
  timing.march = march_watch.seconds() - scheme->factorise_seconds();

  run.summary.title = input.scene.title;
  run.summary.discretisation = discretisation(scene, *scheme, grid, run.response);
  run.summary.discretisation.factorisations += choice.factorisations;
  run.summary.discretisation.solves += choice.factorisations;
  if (scene.compiled.caisson) run.summary.response = read_shear_response(scene.compiled, run.response, time.inertia);
  run.summary.loads = scene.compiled.loads_on_caisson;
  if (!run.response.energy.empty()) run.summary.energy = run.response.energy.back();
  run.summary.skipped = skipped(input, scene);
  run.summary.timing = timing;
  return run;
}

std::vector<Skipped> skipped(const Case& input, const CompiledCase& scene) {
  std::vector<Skipped> list;
  for (const Decision& decision : scene.decisions)
    if (!decision.left_out.empty()) list.push_back({decision.left_out, decision.why});
  for (const auto& [name, load] : input.scene.loads)
    if (load.factor == 0.) {
      list.push_back({"load " + name, "its factor is 0"});
    } else if (const auto& samples = load.history.samples(); is_rough(load.history)) {
      list.push_back({"steps that meet the corners of load " + name,
                      "a rough record of " + std::to_string(samples.size()) +
                          " samples: F_T errs by some of its roughness (8 % for noise of 1 % measured); smooth it, or "
                          "give time.step = its sampling interval, " +
                          significant(samples[1] - samples[0]) + " s"});
    }
  if (!input.scene.fields_every) list.push_back({"fields", "the case asks for none ([output] fields)"});
  if (!scene.compiled.caisson) list.push_back({"shear force", "the mesh has no surface 'caisson'"});
  if (!input.scene.time.inertia) list.push_back({"inertia", "[time] inertia = false: consolidation"});
  return list;
}

}  // namespace upbead
