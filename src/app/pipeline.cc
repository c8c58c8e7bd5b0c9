#include "upbead/app/pipeline.h"

#include <algorithm>

#include "upbead/base/stopwatch.h"
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

CompiledCase compile_case(const Case& input) {
  const Scene& scene = input.scene;
  CompiledCase out;
  const Stopwatch mesh_watch;
  out.mesh = read_mesh(mesh_request(input));
  throw_objections(input, check_scene(scene, *out.mesh));
  out.timing.mesh = mesh_watch.seconds();

  const Stopwatch compile_watch;
  for (const auto& [name, region] : scene.regions)
    if (region.kind == RegionKind::porous) out.flows[name] = choose_flow(region, scene);
  out.space = std::make_unique<Space>(*out.mesh, scene, out.flows);
  const std::vector<Body> bodies = rigid_bodies(*out.space);
  out.unknowns = std::make_unique<Unknowns>(*out.space, scene, bodies);
  out.compiled = compile(scene, *out.space, *out.unknowns, bodies);
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
  }
  const TimeGrid grid = make_time_grid(times_to_meet(input.scene, system), time.end, largest_step);

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
  for (const auto& [name, choice] : scene.flows)
    if (choice.flow != Flow::inertial)
      list.push_back(
          {(choice.flow == Flow::drained ? "pore pressure in " : "relative inertia of the pore water in ") + name,
           choice.reason});
  for (const Body& body : scene.compiled.bodies)
    list.push_back({"deformation of " + body.region, "the region is rigid: three coordinates stand for it"});
  if (!input.scene.fields_every) list.push_back({"fields", "the case asks for none ([output] fields)"});
  if (!scene.compiled.caisson) list.push_back({"shear force", "the mesh has no surface 'caisson'"});
  if (!input.scene.time.inertia) list.push_back({"inertia", "[time] inertia = false: consolidation"});
  return list;
}

}  // namespace upbead
