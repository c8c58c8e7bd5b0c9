#include "findings/support_warnings.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/compile.h"
#include "fem/moving_frame.h"
#include "fem/outline.h"
#include "upbead/fem/load_on_caisson.h"

namespace upbead {

namespace {

constexpr double round_off = 1e-9;

/// Calls visit(degree of freedom, component) for those of u.
template <class Visit>
void for_each_displacement(const Space& space, const Visit& visit) {
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const Dofs dofs = dofs_of(cell);
    for (unsigned i = 0; i < dofs.size(); ++i)
      if (const unsigned component = cell->get_fe().system_to_component_index(i).first; component < dim)
        visit(dofs[i], component);
  }
}

/// The section's unit translation along an axis, as unknowns; none where a condition or a spring holds it.
std::optional<Vector> free_translation(const Simulation& simulation, unsigned axis) {
  const Unknowns& unknowns = *simulation.unknowns();
  const System& system = simulation.system();
  Vector r = Vector::Zero(unknowns.size());
  for_each_displacement(*simulation.space(), [&](auto dof, unsigned component) {
    const Row& row = unknowns.expansion(dof);
    if (component == axis && row.size() == 1 && row[0].first < unknowns.n_free()) r[row[0].first] = 1. / row[0].second;
  });
  for (std::size_t b = 0; b < simulation.compiled()->bodies.size(); ++b)
    for (int m = 0; m < n_motions; ++m) r[unknowns.coordinate(b, m)] = m == (axis == 0 ? motion_x : motion_y) ? 1. : 0.;
  const Vector moved = unknowns.expand(r);
  bool is_free = r.squaredNorm() > 0.;
  for_each_displacement(*simulation.space(), [&](auto dof, unsigned component) {
    is_free = is_free && std::abs(moved[dof] - (component == axis ? 1. : 0.)) < round_off;
  });
  if (!is_free) return {};
  const SparseMatrix sizes = system.K.cwiseAbs();
  if (r.dot(system.K * r) > round_off * r.cwiseAbs().dot(sizes * r.cwiseAbs())) return {};
  return r;
}

/// What the loads do in all along r (N s/m); not the motion of a base, which may shift the section.
double impulse_along(const Simulation& simulation, const Vector& r) {
  const System& system = simulation.system();
  std::set<int> of_frames(system.frame_damping.loads.begin(), system.frame_damping.loads.end());
  of_frames.insert(system.frame_radiation.loads.begin(), system.frame_radiation.loads.end());
  double sum = 0.;
  for (std::size_t k = 0; k < system.loads.size(); ++k) {
    const SystemLoad& load = system.loads[k];
    const double force = load.prescribed < 0 && !of_frames.count(static_cast<int>(k)) ? load.vector.dot(r) : 0.;
    if (std::abs(force) > round_off * load.vector.cwiseAbs().dot(r.cwiseAbs()))
      sum += force * integral(load.history, 0., simulation.scene().time.end);
  }
  return sum;
}

/// Dashpots of the sum D let a section drift by J/D under an impulse J; without any it moves off with J/m.
NumberedWarnings drift_warnings(const Simulation& simulation) {
  constexpr double least_drift = 1e-5;  // m
  NumberedWarnings list;
  if (!simulation.scene().time.inertia || simulation.processes()) return list;
  for (const unsigned axis : {0U, 1U}) {
    const std::optional<Vector> r = free_translation(simulation, axis);
    if (!r) continue;
    const System& system = simulation.system();
    const double impulse = impulse_along(simulation, *r), mass = r->dot(system.M * *r),
                 end = simulation.scene().time.end;
    const double decay = r->dot(system.C * *r) / mass;
    const double drift = impulse / mass * (decay * end > round_off ? -std::expm1(-decay * end) / decay : end);
    if (!(std::abs(drift) > least_drift)) continue;
    const std::string along = axis == 0 ? "horizontally" : "vertically";
    list.push_back(
        {"nothing_holds", std::abs(drift), least_drift, "m",
         "nothing holds the section " + along + " but what resists velocity: the loads' impulse of " +
             significant(impulse) + " N s/m shifts it as a whole by about " + significant(1e3 * drift, 2) +
             " mm until the end, which is in x_G and all displacements",
         "hold a side or the base (displacement = \"fixed\", \"roller\" or \"level\"), or give it a spring"});
  }
  return list;
}

bool is_soil(const Scene& scene, const std::string& surface) {
  const auto region = scene.regions.find(surface);
  return region != scene.regions.end() &&
         (region->second.kind == RegionKind::porous || region->second.kind == RegionKind::solid);
}

NumberedWarnings side_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const bool shaken = std::any_of(scene.loads.begin(), scene.loads.end(), [&](const auto& entry) {
    return entry.second.factor != 0. && scene.boundaries.count(entry.second.boundary) &&
           moves_frame(scene, entry.second);
  });
  if (!shaken) return {};
  std::string names;
  double n = 0.;
  for (const auto& [name, surfaces] : far_sides(*simulation.mesh())) {
    const auto side = scene.boundaries.find(name);
    if (side == scene.boundaries.end() || is_moved(scene, name)) continue;
    const DisplacementCondition condition = side->second.displacement;
    const bool unlike = (condition == DisplacementCondition::free && !side->second.spring) ||
                        condition == DisplacementCondition::absorbing;
    if (!unlike || std::none_of(surfaces.begin(), surfaces.end(), [&](const auto& s) { return is_soil(scene, s); }))
      continue;
    names += (names.empty() ? "'" : ", '") + name + "' (" +
             (condition == DisplacementCondition::free ? "free: it bends" : "absorbing: its dashpots stand at rest") +
             ")";
    n += 1.;
  }
  if (n == 0.) return {};
  return {{"sides_unlike_ground", n, 0., "1",
           "the base is shaken as a whole, but ground that goes on beyond the section would not move as at its side " +
               names + ": the motion is wrong there and, with time, in the middle",
           "say displacement = \"level\" at upright sides of soil"}};
}

/// Constrained modulus (Pa) of the skeleton, and lowest height (m), of the ground that deforms under the caisson. With
/// the stiffness of its water the warning came where steps of a third of an impact changed slip by 0.5 %.
struct GroundBelow {
  double modulus = 0., lowest = infinity;
};

GroundBelow ground_below(const Simulation& simulation) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double half = 0.5 * caisson.bottom_width;
  GroundBelow ground;
  double compliance = 0., thickness = 0.;
  for (const auto& cell : simulation.space()->dofs().active_cell_iterators()) {
    const auto from = cell->center() - caisson.bottom_centre;
    if (simulation.mesh()->surface_of(cell) == caisson_name ||
        !is_soil(simulation.scene(), simulation.mesh()->surface_of(cell)))
      continue;
    for (const unsigned v : cell->vertex_indices()) ground.lowest = std::min(ground.lowest, cell->vertex(v)[1]);
    if (std::abs(from[0]) > half || -from[1] > 2. * half || from[1] > 0.) continue;
    compliance += area_of(cell) / simulation.space()->material(cell).constrained_modulus();
    thickness += area_of(cell);
  }
  if (compliance > 0.) ground.modulus = thickness / compliance;
  return ground;
}

}  // namespace

bool is_moved(const Scene& scene, const std::string& curve) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const auto& entry) {
    return is_motion(entry.second.kind) && entry.second.factor != 0. && entry.second.boundary == curve;
  });
}

NumberedWarnings support_warnings(const Simulation& simulation) {
  NumberedWarnings list = drift_warnings(simulation);
  append(list, side_warnings(simulation));
  return list;
}

/// An impact lasts half a period of the caisson on its ground, pi sqrt(m/k), k = E_oed B over the depth, at most B, in
/// which the ground gives way.
NumberedWarnings impact_warnings(const Solution& solution) {
  constexpr double steps_in_impact = 10.;  // docs/warnings.md
  const Simulation& simulation = *solution.simulation;
  const auto& contact = solution.contact;
  if (!contact || !contact->found.solved || contact->found.solved->impacts == 0 || !simulation.scene().time.inertia)
    return {};
  const Caisson& caisson = *simulation.compiled()->caisson;
  const GroundBelow ground = ground_below(simulation);
  if (!(ground.modulus > 0.)) return {};
  const double depth = std::min(caisson.bottom_width, caisson.bottom_centre[1] - ground.lowest);
  const double k = ground.modulus * caisson.bottom_width / depth, time = pi * std::sqrt(caisson.body.mass / k);
  const double step = solution.discretisation.time_step, limit = time / steps_in_impact;
  if (step <= limit) return {};
  return {{"impact_unresolved", step, limit, "s",
           "the caisson strikes its ground " + std::to_string(contact->found.solved->impacts) +
               " times (nodes), which lasts " + significant(time, 2) + " s on ground as stiff as this, but a step " +
               significant(step) +
               " s: what each impact takes, and with it rocking and slip afterwards, depends on the step",
           "give time.step = " + significant(limit, 2) + " s, or halve it until rocking stays the same"}};
}

}  // namespace upbead
