#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "response/scheme_choice.h"
#include "response/step_choice.h"
#include "response/wave_resolution.h"
#include "scene_warnings.h"

namespace upbead {

namespace {

/// A limit, and what the history of F_T errs by there, over its peak; measured: docs/warnings.md.
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

/// Short waves that damped ground takes away go on: V_s D alone is the wave; measured: docs/warnings.md.
constexpr MeshRule undamped_2{2.3, 0.05, 2.}, undamped_3{1.35, 0.05, 2.5};
constexpr double least_damping = 0.02;  ///< at half a period in the duration of the load

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

std::string rough_percent(double share) {
  return share > 0.5 ? "half or more" : "about " + std::to_string(std::max(1L, std::lround(100. * share))) + " %";
}

}  // namespace

NumberedWarnings step_warnings(const Simulation& simulation) {
  if (!simulation.scene.time.step) return {};
  const std::optional<double> time = passing_time(simulation);
  if (!time) return {};
  const TimeScheme scheme = choose_scheme(simulation.scene, *simulation.compiled).scheme;
  if (scheme == TimeScheme::reduced) return {};
  const StepRule rule = scheme == TimeScheme::generalised_alpha ? of_order_2 : of_order_4;
  const double step = *simulation.scene.time.step, limit = *time / rule.steps;
  if (step <= limit) return {};
  return {{"step_too_coarse", step, limit, "s",
           "time.step = " + significant(step) + " s for waves that pass in " + significant(*time) +
               " s: the history of " + (simulation.compiled->caisson ? "F_T" : "a reading") + " may err by " +
               rough_percent(rule.error * std::pow(step / limit, rule.order)) + " of its peak; give at most " +
               significant(limit, 2) + " s, or step = \"auto\""}};
}

NumberedWarnings jump_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene;
  if (scene.time.inertia || scene.time.scheme != TimeScheme::generalised_alpha || shortest_duration(scene) > 0.)
    return {};
  const double step = scene.time.step.value_or(step_of_loads(scene, 2).largest_step);
  return {{"jump_with_alpha", step, 0., "s",
           "a load jumps, after which generalised_alpha without inertia keeps a false pressure of about a third of a "
           "percent of the "
           "largest, however short the step (" +
               significant(step) +
               " s); F_T does not feel it; write time.scheme = \"sdirk4\", or give the load a rise"}};
}

NumberedWarnings mesh_warnings(const Simulation& simulation) {
  const double duration = shortest_duration(simulation.scene);
  if (!simulation.scene.time.inertia || !std::isfinite(duration) || !simulation.compiled->caisson ||
      simulation.accuracy)
    return {};
  NumberedWarnings list;
  for (const WaveResolution& at : wave_resolution(*simulation.space, *simulation.compiled->caisson, duration)) {
    const bool rings = duration > 0. && is_undamped(simulation.scene.regions.at(at.region), duration);
    const CellsToWave wide =
        cells_to_wave(at, at.wavelength, simulation.space->degree() == 2 ? of_degree_2 : of_degree_3);
    const CellsToWave free =
        cells_to_wave(at, at.speed * duration, simulation.space->degree() == 2 ? undamped_2 : undamped_3);
    const CellsToWave worst = rings && free.error > wide.error ? free : wide;
    if (worst.cells < worst.limit)
      list.push_back({"mesh_too_coarse", worst.cells, worst.limit, "1",
                      "region '" + at.region + "' has cells of " + significant(at.cell, 2) + " m near the caisson, " +
                          significant(worst.cells, 2) + " to a shear wave of " + significant(worst.wavelength, 2) +
                          " m" + (rings ? " (without damping it goes on)" : "") + ": the history of F_T may err by " +
                          rough_percent(worst.error) + " of its peak; refine the mesh" +
                          (rings ? ", give the soil damping" : "") + ", or write mesh.refine = \"auto\""});
  }
  return list;
}

}  // namespace upbead
