// What may be wrong with the numbers of a scene, one question per function; found before anything is solved.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/compile.h"
#include "findings/border_warnings.h"
#include "findings/carried_warnings.h"
#include "findings/finding.h"
#include "findings/load_places.h"
#include "findings/support_warnings.h"
#include "response/drainage.h"
#include "response/ground_waves.h"
#include "response/shear_response.h"
#include "response/slip_law.h"
#include "response/time_choice.h"
#include "run/sliding/uplift.h"

namespace upbead {

namespace {

/// Time in which the shortest wave of a scene passes (s): D + B/V_s, D the loads' shortest duration, B the width of
/// the caisson's bottom and V_s the slowest shear wave of the ground near it; D alone without a caisson. None where
/// no load has a duration, or there is no inertia.
std::optional<double> passing_time(const Simulation& simulation) {
  const double duration = shortest_duration(simulation.scene());
  if (!simulation.scene().time.inertia || !std::isfinite(duration)) return std::nullopt;
  double time = duration;
  if (simulation.compiled()->caisson)
    for (const WaveResolution& at : wave_resolution(*simulation.space(), *simulation.compiled()->caisson, duration))
      time = std::max(time, at.wavelength / at.speed);
  return time > 0. ? std::optional(time) : std::nullopt;
}

/// A limit, and the error of the history of F_T at that limit, over its peak; measured: docs/warnings.md.
struct StepRule {
  double steps;  ///< in the passing time
  double error, order;
};
constexpr StepRule of_order_2{32., 0.02, 2.}, of_order_4{8., 0.015, 2.5};

struct MeshRule {
  double cells;  ///< to a wave
  double error, order;
};
constexpr MeshRule of_degree_2{4., 0.05, 3.}, of_degree_3{3., 0.05, 3.};

/// Without damping short waves do not die away, so the shortest wavelength is V_s D alone; measured:
/// docs/warnings.md.
constexpr MeshRule undamped_2{2.3, 0.05, 2.}, undamped_3{1.35, 0.05, 2.5};
constexpr double least_damping = 0.02;  ///< damping ratio, at a period of twice the load's duration

bool is_undamped(const Region& region, double duration) {
  return !region.strain_law && (!region.damping || region.damping->ratio_at(0.5 / duration) < least_damping);
}

struct CellsToWave {
  double wavelength, cells, limit, error;
};

CellsToWave cells_to_wave(const WaveResolution& at, double wavelength, const MeshRule& rule) {
  const double n = wavelength / at.cell;
  return {wavelength, n, rule.cells, rule.error * std::pow(rule.cells / n, rule.order)};
}

/// Error of the history of F_T from which no verdict is drawn: its peak then errs by several percent, too (18 %
/// measured in steps of ten times the limit).
constexpr double errs_too_much = 0.5;

std::string rough_percent(double share) {
  return share > errs_too_much ? "half or more"
                               : "about " + std::to_string(std::max(1L, std::lround(100. * share))) + " %";
}

/// Warning step_too_coarse: a march in steps that the case gives, longer than an 8th of passing_time (order 4) or a
/// 32nd of it (order 2).
NumberedWarnings warnings_of_steps(const Simulation& simulation, TimeScheme scheme, double step) {
  const std::optional<double> time = passing_time(simulation);
  if (!time) return {};
  const StepRule rule = scheme == TimeScheme::generalised_alpha ? of_order_2 : of_order_4;
  const double limit = *time / rule.steps;
  if (step <= limit) return {};
  const double error = rule.error * std::pow(step / limit, rule.order);
  return {{"step_too_coarse", step, limit, "s",
           "time.step = " + significant(step) + " s for waves that pass in " + significant(*time) +
               " s: the history of " + (simulation.compiled()->caisson ? "F_T" : "a reading") + " may err by " +
               rough_percent(error) + " of its peak",
           "give time.step at most " + significant(limit, 2) + " s, or step = \"auto\"", error > errs_too_much}};
}

bool is_to_be_reduced(const Simulation& simulation) {
  return choose_scheme(simulation.scene(), *simulation.compiled()).scheme == TimeScheme::reduced;
}

/// None where a reduced model is to answer.
NumberedWarnings step_warnings(const Simulation& simulation) {
  if (!simulation.scene().time.step || is_to_be_reduced(simulation)) return {};
  return warnings_of_steps(simulation, choose_scheme(simulation.scene(), *simulation.compiled()).scheme,
                           *simulation.scene().time.step);
}

/// Where a reduced model was to answer, and it was marched all the same.
NumberedWarnings warnings_of_march(const Evidence& e, const Summary&) {
  if (e.solution.model || !e.scene.time.step || !is_to_be_reduced(e.simulation)) return {};
  return warnings_of_steps(e.simulation, TimeScheme::sdirk4, e.solution.discretisation.time_step);
}

/// Warning jump_with_alpha: consolidation under a load that jumps, marched by generalised-alpha.
NumberedWarnings jump_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (scene.time.inertia || scene.time.scheme != TimeScheme::generalised_alpha || shortest_duration(scene) > 0.)
    return {};
  const double step = scene.time.step.value_or(step_of_loads(scene, 2).largest_step);
  return {{"jump_with_alpha", step, 0., "s",
           "a load jumps, after which generalised_alpha without inertia keeps a false pressure of about a third of a "
           "percent of the largest, however short the step (" +
               significant(step) + " s); F_T is not affected",
           "write time.scheme = \"sdirk4\", or give the load a rise"}};
}

/// Warning motion_stays: a boundary still moves at the end of its record.
NumberedWarnings motion_warnings(const Simulation& simulation) {
  constexpr double at_rest = 0.05;  // of the largest velocity
  NumberedWarnings list;
  for (const auto& [name, load] : simulation.scene().loads) {
    if (load.kind != LoadKind::acceleration || load.factor == 0. || load.history.kinks().empty()) continue;
    const double last = load.history.kinks().back(), end = simulation.scene().time.end;
    if (last > end) continue;
    const double largest =
        std::max(extremum(load.history, 0., end, 1).value, -extremum(load.history, 0., end, -1).value);
    const double left = load.history(last);
    if (std::abs(left) <= at_rest * largest) continue;
    list.push_back({"motion_stays", left, at_rest * largest, "m/s",
                    "load '" + name + "' ends with a velocity of " + significant(left) + " m/s, " +
                        significant(100. * std::abs(left) / largest, 2) +
                        " % of its largest, and keeps it: the ground goes on moving, by " +
                        significant(left * (end - last), 2) +
                        " m until the end; where it should come to rest, the record lacks its end, or has an offset; "
                        "where it is meant, as of a base that is set in motion, nothing is wrong",
                    "give the whole record, or its velocity or displacement"});
  }
  return list;
}

/// Warning mesh_too_coarse: fewer than 4 cells in a wavelength (response/ground_waves.h), or 3 where u is of degree
/// 3; not where the mesh was made for the tolerance.
NumberedWarnings mesh_warnings(const Simulation& simulation) {
  const double duration = shortest_duration(simulation.scene());
  if (!simulation.scene().time.inertia || !std::isfinite(duration) || !simulation.compiled()->caisson ||
      simulation.accuracy())
    return {};
  NumberedWarnings list;
  for (const WaveResolution& at : wave_resolution(*simulation.space(), *simulation.compiled()->caisson, duration)) {
    const bool rings = duration > 0. && is_undamped(simulation.scene().regions.at(at.region), duration);
    const CellsToWave wide =
        cells_to_wave(at, at.wavelength, simulation.space()->degree() == 2 ? of_degree_2 : of_degree_3);
    const CellsToWave free =
        cells_to_wave(at, at.speed * duration, simulation.space()->degree() == 2 ? undamped_2 : undamped_3);
    const CellsToWave worst = rings && free.error > wide.error ? free : wide;
    if (worst.cells < worst.limit)
      list.push_back({"mesh_too_coarse", worst.cells, worst.limit, "1",
                      "region '" + at.region + "' has cells of " + significant(at.cell, 2) + " m near the caisson, " +
                          significant(worst.cells, 2) + " to a shear wave of " + significant(worst.wavelength, 2) +
                          " m" + (rings ? " (without damping it goes on)" : "") + ": the history of F_T may err by " +
                          rough_percent(worst.error) + " of its peak",
                      "refine the mesh" + std::string(rings ? ", give the soil damping" : "") +
                          ", or write mesh.refine = \"auto\"",
                      worst.error > errs_too_much});
  }
  return list;
}

/// Factor on the time of the echo until it has an effect, by the distance in widths of the caisson: from far away the
/// echo is spread. docs/warnings.md.
double delay(double widths) {
  return widths > 5. ? 1.2 : 1.;
}

std::string cure(const BoundaryReflection& reflection, double end) {
  return "move the side '" + reflection.side + "' to " + significant(0.5 * reflection.speed * end) + " m" +
         (reflection.absorbing ? " (saturated ground absorbs little)" : ", or end the run before");
}

/// Warning walls_too_near: the first echo of a far side is back before the end (for sides beyond 5 B before 1/1.2 of
/// it), and the loads are shorter than the echo takes, or the side is nearer than the caisson is wide. `peak_time`:
/// of F_T, where that is known.
NumberedWarnings wall_warnings(const Simulation& simulation, const std::optional<double>& peak_time) {
  const double end = simulation.scene().time.end;
  const std::optional<double> time = passing_time(simulation);
  if (!time || !simulation.compiled()->caisson) return {};
  const std::optional<BoundaryReflection> reflection = first_reflection(simulation.scene(), *simulation.space());
  if (!reflection ||
      reflection->time() * delay(reflection->distance / simulation.compiled()->caisson->bottom_width) >= end)
    return {};
  const bool is_fast = shortest_duration(simulation.scene()) < reflection->time();
  if (!is_fast && reflection->distance >= simulation.compiled()->caisson->bottom_width) return {};
  const double peak_in_it = peak_time && *peak_time > reflection->time() ? *peak_time : 0.;
  return {{"walls_too_near", reflection->time(), end, "s",
           "the side '" + reflection->side + "' is " + significant(reflection->distance) + " m away, shear waves of " +
               significant(reflection->speed) + " m/s are back after " + significant(reflection->time()) +
               " s, before the end at " + significant(end) + " s: from " + significant(reflection->time()) +
               " s on F_T(t) contains its echo" +
               (peak_in_it > 0. ? ", its peak at " + significant(peak_in_it) + " s with it" : ""),
           cure(*reflection, end)}};
}

/// Concrete, whatever the fill weighs: a rigid region has no stiffness of its own.
constexpr double youngs_modulus = 30e9, poissons_ratio = 0.2;
/// Number of crossings of the caisson by sound; for shorter loads the error of peak F_T exceeds 2 %:
/// docs/warnings.md.
constexpr double least_crossings = 4.;

/// Time from the beginning of the first horizontal load on the caisson to the end of the last one (s). The whole run
/// where a load lasts, as the slow part of a load makes the peak of F_T even where it begins with a jump.
double time_of_loads(const Simulation& simulation) {
  double first = simulation.scene().time.end, last = 0.;
  for (std::size_t k = 0; k < simulation.compiled()->loads_on_caisson.size(); ++k) {
    const TimeFunction& f = simulation.system().loads[k].history;
    if (!simulation.compiled()->loads_on_caisson[k].arm() || f.kinks().empty()) continue;
    first = std::min(first, f.kinks().front());
    last = std::max(last, f(f.kinks().back() + 1.) == 0. ? f.kinks().back() : simulation.scene().time.end);
  }
  return last > first ? last - first : simulation.scene().time.end;
}

/// Warning fast_load: all loads on the rigid caisson are over before sound has crossed it four times.
NumberedWarnings load_warnings(const Simulation& simulation) {
  if (!simulation.compiled()->caisson || !simulation.scene().time.inertia) return {};
  if (simulation.scene().regions.at(caisson_name).kind != RegionKind::rigid) return {};
  double left = infinity, right = -infinity, area = 0.;
  for (const auto& cell : simulation.mesh()->triangulation.active_cell_iterators()) {
    if (simulation.mesh()->surface_of(cell) != caisson_name) continue;
    area += area_of(cell);
    for (const unsigned v : cell->vertex_indices()) {
      left = std::min(left, cell->vertex(v)[0]);
      right = std::max(right, cell->vertex(v)[0]);
    }
  }
  const double constrained =
      youngs_modulus * (1. - poissons_ratio) / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
  const double sound = std::sqrt(constrained * area / simulation.compiled()->caisson->body.mass);
  const double limit = least_crossings * (right - left) / sound, time = time_of_loads(simulation);
  if (time >= limit) return {};
  return {{"fast_load", time, limit, "s",
           "the loads are over within " + significant(time) + " s, but sound takes " +
               significant(limit / least_crossings) + " s to cross the caisson (E = 30 GPa assumed, as it is rigid): " +
               "its own deformation changes peak F_T by 2 to 15 %",
           "make the caisson kind = \"solid\""}};
}

/// Warnings load_zero and load_cut of a prescribed uplift that follows P so late that the run does not see it.
NumberedWarnings uplift_warnings(const Simulation& simulation) {
  constexpr double nearly_all = 0.99;
  const auto& sliding = simulation.scene().sliding;
  if (!simulation.compiled()->caisson || !sliding || !sliding->uplift || !sliding->uplift->peak) return {};
  const UpliftChoice& uplift = *sliding->uplift;
  const double end = simulation.scene().time.end, peak = *uplift.peak;
  const TimeFunction P = force_on_caisson(*simulation.compiled());
  const double seen = extremum(prescribed_uplift(uplift, P, end), 0., end, 1).value;
  const double landward = extremum(P, 0., end, 1).value, seaward = -extremum(P, 0., end, -1).value;
  if (landward < 0.5 * seaward && !pushes_seaward_alone(landward, -seaward))
    return {{"uplift_left_out", landward, seaward, "N/m",
             "the prescribed uplift follows the landward force, of up to " + with_unit(landward, "N/m") +
                 "; none acts with the seaward one of " + with_unit(seaward, "N/m"),
             "give the uplift over time (sliding.uplift.history) where waves press on the landward wall"}};
  if (!(landward > 0. || seaward > 0.) || seen >= nearly_all * peak) return {};
  return {
      {seen > 0. ? "load_cut" : "load_zero", uplift.lag, end, "s",
       "the prescribed uplift follows P by " + significant(uplift.lag) + " s, and the run ends at " + significant(end) +
           " s: " + (seen > 0. ? "no more than " + percent(seen / peak) + " of its peak acts" : "nothing of it acts"),
       "look at the unit of sliding.uplift.lag (s), or give a longer time.end", true}};
}

/// A pulse builds up the pressure beside the face as a jump would that takes this share of the pulse's duration.
constexpr double share_of_pulse = 1. / 6.;
/// Number of cells beside the face with wrong pressures: the first one, and a little of the next.
constexpr double reach = 1.2;

/// Whether a point lies on the soil's side.
bool is_inside(const dealii::Point<dim>& point, const DrainedFace& face) {
  return (point - face.first) * (face.inside - face.first) >= 0.;
}

/// Name of a probe in the soil, within reach of the face; "fields" where there are fields; else "".
std::string onlooker(const Scene& scene, const DrainedFace& face) {
  if (scene.fields_every) return "fields";
  for (const auto& [name, probe] : scene.probes)
    if (is_inside({probe.at[0], probe.at[1]}, face) &&
        distance_to_line({probe.at[0], probe.at[1]}, face.first, face.last) < reach * face.cell)
      return "probe '" + name + "'";
  return "";
}

/// Time within which the loads change (s): a share of their duration, or the step at a jump.
double build_up(const Scene& scene) {
  const double duration = shortest_duration(scene);
  const double jump = duration > 0. ? 0. : step_of_loads(scene, 4).largest_step;
  return std::max(share_of_pulse * duration, scene.time.step.value_or(jump));
}

/// Warning smallest_step: the pressure at a probe or in the fields oscillates from cell to cell beside a face where
/// soil drains (response/drainage.h).
NumberedWarnings boundary_layer_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (scene.probes.empty() && !scene.fields_every) return {};
  const int degree = simulation.space()->degree() - 1;
  const double time = build_up(scene);
  if (!(time > 0.) || time > scene.time.end) return {};
  std::map<std::string, NumberedWarning> worst;  // by soil
  for (const DrainedFace& face : drained_faces(scene, *simulation.mesh())) {
    const double limit = smallest_time(face, degree);
    if (time >= limit) continue;
    const std::string who = onlooker(scene, face);
    if (who.empty() || (worst.count(face.region) && limit <= worst[face.region].limit)) continue;
    const std::string formula = degree == 1 ? "h^2/(6 c_v)" : "h^2/(40 c_v)";
    worst[face.region] = {
        "smallest_step",
        time,
        limit,
        "s",
        who + ": where '" + face.region + "' drains into '" + face.into + "' its pressure builds up within " +
            significant(time) + " s, less than " + formula + " = " + significant(limit) + " s of its cells of " +
            significant(face.cell, 2) + " m: it overshoots by up to " +
            significant(100. * overshoot(face, degree, time), 2) + " % from cell to cell there; F_T is not affected",
        "take cells half as high where '" + face.region + "' drains into '" + face.into + "', or mesh.degree = 3"};
  }
  NumberedWarnings list;
  for (const auto& [soil, warning] : worst) list.push_back(warning);
  return list;
}

/// Largest error of F_T where the false compliance of a layer exceeds all other: the largest of ten scenes,
/// docs/warnings.md.
constexpr double whole_layer_error = 0.25, largest_layer_error = 0.05;

std::string cure(const DrainedLayer& layer, int degree) {
  constexpr double share = largest_layer_error / whole_layer_error, ratio = share / (1. - share);
  const double skin = layer.skin / layer.stiffness;  // its compliance (m/Pa)
  const double cell = degree * (layer.skin + layer.stiffness * layer.of_the_rest * ratio);
  const bool water_stays = skin <= ratio * (layer.of_the_rest - skin);
  return "take cells of at most " + significant(cell, 2) + " m in '" + layer.region + "' beside '" + layer.into + "'" +
         (water_stays
              ? ", or, as its water stays, kind = \"solid\" with poissons_ratio = 0.499 and its density with water"
              : "");
}

/// Warning drained_layer: the drainage of soil under the caisson is set by the size of its cells and not by its
/// conductivity, which softens the ground so much that F_T may err by more than 5 % (response/drainage.h); not where
/// the mesh was made for the tolerance.
NumberedWarnings layer_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (!simulation.compiled()->caisson || !scene.time.inertia || simulation.accuracy()) return {};
  const double duration = step_of_loads(scene, 4).duration;
  const std::optional<DrainedLayer> layer =
      drained_layer(scene, *simulation.space(), *simulation.compiled()->caisson, 0.5 * duration);
  if (!layer) return {};
  const double error = whole_layer_error * layer->share();
  if (error <= largest_layer_error) return {};
  return {{"drained_layer", error, largest_layer_error, "1",
           "water leaves a skin of " + significant(layer->skin, 2) + " m of '" + layer->region + "' into '" +
               layer->into + "' within " + significant(0.5 * duration) + " s, but cells of " +
               significant(layer->cell, 2) + " m drain a thicker one, which makes " +
               std::to_string(std::lround(100. * layer->share())) +
               " % of the compliance of the ground under the caisson" + ": F_T may err by up to " +
               std::to_string(std::lround(100. * error)) + " %",
           cure(*layer, simulation.space()->degree())}};
}

/// Warning mesh_too_coarse: a thin soft layer whose cells are longer than it is thick (response/ground_waves.h).
NumberedWarnings thin_layer_warnings(const Simulation& simulation) {
  constexpr double least = 1.;  // thickness over the cells' length: docs/warnings.md
  if (!simulation.scene().time.inertia || !simulation.compiled()->caisson || simulation.accuracy()) return {};
  NumberedWarnings list;
  for (const ThinLayer& layer : thin_layers(*simulation.space(), *simulation.compiled()->caisson))
    if (const double n = layer.cells_per_thickness(); n < least)
      list.push_back({"mesh_too_coarse", n, least, "1",
                      "region '" + layer.region + "' is a soft layer of " + significant(layer.thickness, 2) +
                          " m under the caisson with cells up to " + significant(layer.longest, 2) +
                          " m long: what happens at its ends is not resolved, and F_T may err by several percent",
                      "refine the mesh along the layer, or write mesh.refine = \"auto\" or accuracy.estimate = true"});
  return list;
}

NumberedWarnings scene_warnings(const Simulation& simulation, const std::optional<double>& peak_time) {
  NumberedWarnings all;
  for (const NumberedWarnings& part :
       {step_warnings(simulation), jump_warnings(simulation), motion_warnings(simulation), mesh_warnings(simulation),
        wall_warnings(simulation, peak_time), load_warnings(simulation), uplift_warnings(simulation),
        boundary_layer_warnings(simulation), ring_warnings(simulation), slow_wave_warnings(simulation),
        layer_warnings(simulation), thin_layer_warnings(simulation), support_warnings(simulation),
        border_warnings(simulation), load_place_warnings(simulation)})
    append(all, part);
  return all;
}

/// What the scene lets be left out, with the numbers; `reduced`: whether a reduced model solves it.
SkippedList skipped_in_scene(const Simulation& simulation, bool reduced) {
  SkippedList list;
  for (const Decision& decision : simulation.decisions())
    if (!decision.left_out.empty()) list.push_back({decision.left_out, decision.why});
  for (const auto& [name, load] : simulation.scene().loads)
    if (load.factor == 0.) {
      list.push_back({"load " + name, "its factor is 0"});
    } else if (const auto& samples = load.history.samples(); !reduced && is_rough(load.history)) {
      list.push_back({"steps that meet the corners of load " + name,
                      "a rough record of " + std::to_string(samples.size()) +
                          " samples: F_T errs by some of its roughness (8 % for noise of 1 % measured); use "
                          "time.scheme = \"reduced\", smooth it, or give time.step = its sampling interval, " +
                          significant(samples[1] - samples[0]) + " s"});
    }
  if (!simulation.scene().fields_every) list.push_back({"fields", "the case asks for none ([output] fields)"});
  if (!simulation.scene().time.inertia) list.push_back({"inertia", "[time] inertia = false: consolidation"});
  return list;
}

}  // namespace

Finding scene_finding() {
  Finding f;
  f.of_scene = scene_warnings;
  f.skipped_of_scene = skipped_in_scene;
  f.warnings = warnings_of_march;
  return f;
}

}  // namespace upbead
