#include "upbead/app/pipeline.h"

#include "accuracy/adapt.h"
#include "accuracy/error_account.h"
#include "compile_on.h"
#include "contact/contact_report.h"
#include "contact/contact_run.h"
#include "contact/rest_forces.h"
#include "ladder.h"
#include "records/gauge_report.h"
#include "records/record_notes.h"
#include "size_check.h"
#include "sliding/case_sliding.h"
#include "sliding/read_sliding.h"
#include "upbead/app/equivalent_linear.h"
#include "upbead/base/error.h"
#include "upbead/base/stopwatch.h"
#include "upbead/base/text.h"
#include "upbead/fem/scene_check.h"
#include "upbead/system/part.h"
#include "warnings/scene_warnings.h"
#include "warnings/scene_watch.h"

namespace upbead {

namespace {

void throw_objections(const Case& input, const std::vector<Objection>& objections) {
  Mistakes mistakes;
  for (const Objection& objection : objections)
    mistakes.add(input.place(objection.key), objection.what, objection.cure);
  mistakes.throw_if_any();
}

/// On the mesh that the case states.
CompiledCase compile_meshed(const Case& input, std::shared_ptr<const Mesh> mesh,
                            std::shared_ptr<const Processes> processes) {
  const Stopwatch watch;
  if (!mesh) mesh = read_mesh(mesh_request(input));
  const double seconds = watch.seconds();
  CompiledCase scene = compile_on(input, std::move(mesh), std::move(processes));
  scene.timing.mesh = seconds;
  return scene;
}

/// On the mesh that all processes have found alike, each for itself.
CompiledCase compile_adapted_among(const Case& input, std::shared_ptr<const Processes> processes) {
  CompiledCase scene = compile_adapted(input);
  scene.with_interface = has_frictional_contact(scene.scene);
  if (!processes && !scene.with_interface) return scene;
  const Stopwatch watch;
  scene.processes = std::move(processes);
  recompile(scene, scene.soil_state);
  scene.timing.compile += watch.seconds();
  return scene;
}

}  // namespace

CompiledCase compile_case(const Case& input, std::shared_ptr<const Mesh> mesh,
                          std::shared_ptr<const Processes> processes) {
  check_size(input);
  CompiledCase scene = input.scene.mesh.refine ? compile_meshed(input, std::move(mesh), processes)
                                               : compile_adapted_among(input, processes);
  if (!processes) return scene;
  const Stopwatch watch;
  std::vector<int>& coordinates = scene.compiled.body_coordinates;
  const std::vector<int> index = divide(scene.compiled.system, coordinates, std::move(processes));
  for (int& i : coordinates) i = index[i];
  scene.timing.compile += watch.seconds();
  return scene;
}

CompiledCase compile_on(const Case& input, std::shared_ptr<const Mesh> mesh,
                        std::shared_ptr<const Processes> processes) {
  const Stopwatch compile_watch;
  CompiledCase out;
  out.mesh = std::move(mesh);
  out.processes = std::move(processes);
  throw_objections(input, check_scene(input.scene, *out.mesh));
  ResolvedScene resolved = resolve(input.scene, *out.mesh);
  out.scene = std::move(resolved.scene);
  out.decisions = std::move(resolved.decisions);
  out.absent = std::move(resolved.absent);
  out.with_interface = input.scene.mesh.refine && has_frictional_contact(out.scene);
  recompile(out, resolved.soil);
  check_sliding(input, out.compiled);
  check_at_rest(input, out);
  out.timing.compile = compile_watch.seconds();
  return out;
}

void recompile(CompiledCase& scene, const SoilState& soil) {
  scene.unknowns.reset();  // it stands on the space
  scene.soil_state = soil;
  scene.space = std::make_unique<Space>(*scene.mesh, scene.scene, scene.absent, soil);
  const std::vector<Body> bodies = rigid_bodies(*scene.space);
  const std::vector<InterfaceNode> nodes =
      scene.with_interface ? interface_nodes(*scene.space) : std::vector<InterfaceNode>();
  scene.unknowns = std::make_unique<Unknowns>(*scene.space, scene.scene, bodies, nodes);
  scene.compiled = compile(scene.scene, *scene.space, *scene.unknowns, bodies, scene.processes.get(), nodes);
}

namespace {

/// A case that names a scheme is told, where that is refused, whether another one answers. Contact has but one.
Run solve_glued(const Case& input, const CompiledCase& scene, const MarchOptions& marching,
                const std::function<void(double)>& reducing) {
  try {
    return run_glued(input, scene, marching, reducing);
  } catch (const NumericsError& error) {
    throw NumericsError(error.what() + what_would_work(input, scene, reducing));
  }
}

NumberedWarnings balance_warnings(const Case& input, const CompiledCase& scene, const Run& run) {
  const std::optional<Mismatch> off = imbalance(input, scene, run);
  if (!off) return {};
  return {
      {"balance_loose", off->value, off->tolerable, "1",
       off->what + " by " + significant(off->value) + ", where " + significant(off->tolerable) +
           " is usual: large forces cancel in this scene and leave their round-off; F_T may err by up to " +
           significant(off->error, 2) + " of its largest value, motions by that part of what the loads would do " +
           "alone; look for stiffnesses or permeabilities far from all others, or give the water its bulk modulus"}};
}

NumberedWarnings loose_warnings(const Summary& summary) {
  NumberedWarnings list;
  if (!summary.reduction || summary.reduction->loose.empty()) return list;
  std::string names;
  for (const LooseReading& reading : summary.reduction->loose) names += (names.empty() ? "" : ", ") + reading.name;
  list.push_back({"reading_not_converged", summary.reduction->error_of_others, summary.reduction->tolerance_of_others,
                  "1",
                  "the reduced model that was asked for has F_T within its tolerance, but " + names +
                      " move by up to " + significant(summary.reduction->error_of_others) +
                      " of their peaks between nested models; write time.scheme = \"sdirk4\" where they matter"});
  return list;
}

}  // namespace

Run run_case(const Case& input, CompiledCase& scene, const MarchOptions& marching,
             const std::function<void(double)>& reducing) {
  settle_soil(input, scene, reducing);
  SceneWatch watch(scene);
  const MarchOptions watched = watch.watching(marching);
  Run run = scene.compiled.system.interface ? run_contact(input, scene, watched, reducing)
                                            : solve_glued(input, scene, watched, reducing);
  estimate_errors(input, scene, run);
  run.summary.title = input.scene.title;
  run.summary.soil = scene.soil;
  run.summary.loads = scene.compiled.loads_on_caisson;
  run.summary.gauges = gauge_summaries(input, scene);
  run.summary.skipped = skipped(input, scene, run.summary.reduction.has_value());
  watch.tell(input, scene, run);
  for (const NumberedWarnings& list : {loose_warnings(run.summary), balance_warnings(input, scene, run)})
    run.summary.warnings.insert(run.summary.warnings.end(), list.begin(), list.end());
  if (run.summary.sliding)
    for (Skipped& item : skipped(*run.summary.sliding)) run.summary.skipped.push_back(std::move(item));
  if (run.summary.contact && !run.summary.contact->solved)
    run.summary.skipped.push_back({"contact node by node", why_glued(*run.summary.contact)});
  return run;
}

NumberedWarnings warnings(const Case& input, const CompiledCase& scene) {
  return scene_warnings(input, scene);
}

std::vector<Skipped> skipped(const Case& input, const CompiledCase& scene, bool reduced) {
  std::vector<Skipped> list;
  for (const Decision& decision : scene.decisions)
    if (!decision.left_out.empty()) list.push_back({decision.left_out, decision.why});
  for (const auto& [name, load] : input.scene.loads)
    if (load.factor == 0.) {
      list.push_back({"load " + name, "its factor is 0"});
    } else if (const auto& samples = load.history.samples(); !reduced && is_rough(load.history)) {
      list.push_back({"steps that meet the corners of load " + name,
                      "a rough record of " + std::to_string(samples.size()) +
                          " samples: F_T errs by some of its roughness (8 % for noise of 1 % measured); use "
                          "time.scheme = \"reduced\", smooth it, or give time.step = its sampling interval, " +
                          significant(samples[1] - samples[0]) + " s"});
    }
  for (const LeftOut& part : record_notes(input).left_out) list.push_back({part.what, part.why});
  if (!input.scene.fields_every) list.push_back({"fields", "the case asks for none ([output] fields)"});
  if (!scene.compiled.caisson) list.push_back({"shear force", "the mesh has no surface 'caisson'"});
  if (scene.compiled.caisson && !has_strength(input.scene))
    list.push_back({"strength of the soil", "no region has a table strength"});
  if (!input.scene.time.inertia) list.push_back({"inertia", "[time] inertia = false: consolidation"});
  return list;
}

}  // namespace upbead
