#include "upbead/run/simulation.h"

#include "base/stopwatch.h"
#include "dynamics/basis.h"
#include "fem/compile.h"
#include "fem/curve_course.h"
#include "fem/scene_check.h"
#include "fem/system_scene.h"
#include "run/accuracy/accuracy.h"
#include "run/contact/contact_run.h"
#include "run/derived.h"
#include "run/sliding/case_sliding.h"
#include "system/interface.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

Simulation::Parts resolved_on(const Scene& given, std::shared_ptr<const Mesh> mesh,
                              std::shared_ptr<const Processes> processes) {
  check_scene(given, *mesh).throw_if_any();
  Simulation::Parts out;
  out.given = given;
  out.given_mesh = out.mesh = std::move(mesh);
  out.processes = std::move(processes);
  ResolvedScene resolved = resolve(given, *out.mesh);
  out.scene = std::move(resolved.scene);
  out.decisions = std::move(resolved.decisions);
  out.absent = std::move(resolved.absent);
  out.soil_state = std::move(resolved.soil);
  out.with_interface = given.mesh.refine && has_frictional_contact(out.scene);
  return out;
}

Simulation on_mesh(const Scene& given, std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Processes> processes,
                   const Simulation* before) {
  const Stopwatch watch;
  const Simulation::Parts resolved = resolved_on(given, std::move(mesh), std::move(processes));
  const std::optional<Simulation> kept = before != nullptr ? taken_over(resolved, *before) : std::nullopt;
  const Simulation out = kept ? *kept : assembled(resolved);
  check_sliding(out);
  check_at_rest(out);
  return out.with([&](auto& parts) { parts.timing.compile = watch.seconds(); });
}

Simulation assembled(Simulation::Parts parts) {
  AssembledScene made = assemble_scene(parts.scene, *parts.mesh, parts.absent, parts.soil_state, parts.with_interface,
                                       parts.processes.get());
  parts.space = std::move(made.space);
  parts.unknowns = std::move(made.unknowns);
  parts.compiled = std::move(made.compiled);
  parts.room = nullptr;
  return Simulation(std::move(parts));
}

std::optional<Simulation> taken_over(Simulation::Parts parts, const Simulation& before) {
  const Simulation::Parts& kept = before.parts();
  const bool is_same = kept.room && !kept.processes && !parts.processes && kept.mesh == parts.mesh &&
                       kept.absent == parts.absent && kept.with_interface == parts.with_interface &&
                       kept.soil_state.shear_modulus == parts.soil_state.shear_modulus &&
                       kept.soil_state.damping_ratio == parts.soil_state.damping_ratio &&
                       kept.soil_state.pore_fluid == parts.soil_state.pore_fluid &&
                       kept.soil_state.conductivity == parts.soil_state.conductivity &&
                       system_scene(kept.scene) == system_scene(parts.scene);
  if (!is_same) return std::nullopt;
  parts.space = kept.space;
  parts.unknowns = kept.unknowns;
  const auto compiled = std::make_shared<CompiledScene>(*kept.compiled);
  take_courses(parts.scene, *compiled);
  parts.compiled = compiled;
  parts.room = kept.room;
  return Simulation(std::move(parts));
}

Simulation with_room(const Simulation& simulation) {
  if (simulation.room()) return simulation;
  return simulation.with([](auto& parts) { parts.room = std::make_shared<BasisRoom>(); });
}

namespace {

/// What is assembled, to be changed: a copy where others have it, too, as M, C and K are large.
std::shared_ptr<CompiledScene> taken(std::shared_ptr<const CompiledScene> compiled) {
  if (compiled.use_count() > 1) return std::make_shared<CompiledScene>(*compiled);
  return std::const_pointer_cast<CompiledScene>(std::move(compiled));
}

Simulation divided(Simulation simulation) {
  if (!simulation.processes()) return simulation;
  const Stopwatch watch;
  std::shared_ptr<const CompiledScene> whole = simulation.compiled();
  simulation = simulation.with([](auto& parts) { parts.compiled = nullptr; });
  const std::shared_ptr<CompiledScene> compiled = taken(std::move(whole));
  const std::vector<int> index = divide(compiled->system, compiled->body_coordinates, simulation.processes());
  for (int& i : compiled->body_coordinates) i = index[static_cast<std::size_t>(i)];
  for (Vector& motion : compiled->caisson_motions) {
    const Vector of_all = motion;
    motion.resize(compiled->system.size());
    for (std::size_t i = 0; i < index.size(); ++i)
      if (index[i] >= 0) motion[index[i]] = of_all[static_cast<Eigen::Index>(i)];
  }
  return simulation.with([&](auto& parts) {
    parts.compiled = compiled;
    parts.room = nullptr;
    parts.timing.compile += watch.seconds();
  });
}

}  // namespace

Simulation with_soil(const Simulation& simulation, const SoilState& soil) {
  return divided(assembled(simulation.with([&](auto& parts) { parts.soil_state = soil; }).parts()));
}

Simulation with_given(const Simulation& simulation, const Scene& given) {
  return simulation.with([&](auto& parts) {
    parts.given = given;
    parts.scene = given;
    parts.scene.regions = simulation.scene().regions;  // resolved
    parts.scene.tolerance = simulation.scene().tolerance;
    follow_curves(*simulation.mesh(), parts.scene);
  });
}

Simulation with_system(const Simulation& simulation, std::shared_ptr<const CompiledScene> compiled) {
  return simulation.with([&](auto& parts) {
    parts.compiled = std::move(compiled);
    parts.member = nullptr;
    parts.room = nullptr;
  });
}

Simulation bonded(const Simulation& simulation) {
  if (!simulation.system().interface) return simulation;
  CompiledScene compiled = *simulation.compiled();
  compiled.system = bonded(simulation.system());
  return with_system(simulation, std::make_shared<CompiledScene>(std::move(compiled)));
}

namespace {

/// Every process adapts the mesh for itself, by the same errors.
Simulation adapted_among(const Scene& given, std::shared_ptr<const Mesh> mesh,
                         std::shared_ptr<const Processes> processes) {
  const Simulation simulation = adapted(given, std::move(mesh), Layout(processes, {}));
  const bool with_interface = has_frictional_contact(simulation.scene());
  if (!processes && !with_interface) return simulation;
  const Stopwatch watch;
  Simulation::Parts parts = simulation.parts();
  parts.with_interface = with_interface;
  parts.processes = std::move(processes);
  return assembled(std::move(parts)).with([&](auto& made) { made.timing.compile += watch.seconds(); });
}

}  // namespace

Simulation::Simulation(Scene asked, std::shared_ptr<const Mesh> on, std::shared_ptr<const Processes> among) {
  check_size(asked);
  *this = divided(asked.mesh.refine ? on_mesh(asked, std::move(on), std::move(among))
                                    : adapted_among(asked, std::move(on), std::move(among)));
}

Simulation::Simulation(Scene asked, std::shared_ptr<const Mesh> on, const Simulation& before) {
  check_size(asked);
  *this = asked.mesh.refine ? on_mesh(asked, std::move(on), nullptr, &before)
                            : adapted_among(asked, std::move(on), nullptr);
}

const System& Simulation::system() const {
  return compiled()->system;
}

}  // namespace upbead
