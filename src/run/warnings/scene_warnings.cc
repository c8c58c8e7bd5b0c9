#include "scene_warnings.h"

#include <algorithm>
#include <cmath>

#include "response/wave_resolution.h"

namespace upbead {

std::optional<double> passing_time(const Simulation& simulation) {
  const double duration = shortest_duration(simulation.scene);
  if (!simulation.scene.time.inertia || !std::isfinite(duration)) return std::nullopt;
  double time = duration;
  if (simulation.compiled->caisson)
    for (const WaveResolution& at : wave_resolution(*simulation.space, *simulation.compiled->caisson, duration))
      time = std::max(time, at.wavelength / at.speed);
  return time > 0. ? std::optional(time) : std::nullopt;
}

NumberedWarnings warnings(const Simulation& simulation, const std::optional<double>& peak_time) {
  NumberedWarnings all;
  for (const NumberedWarnings& part :
       {step_warnings(simulation), jump_warnings(simulation), mesh_warnings(simulation),
        wall_warnings(simulation, peak_time), load_warnings(simulation), skin_warnings(simulation),
        ring_warnings(simulation), slow_wave_warnings(simulation), layer_warnings(simulation),
        thin_layer_warnings(simulation)})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace upbead
