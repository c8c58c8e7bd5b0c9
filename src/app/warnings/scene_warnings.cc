#include "scene_warnings.h"

#include <algorithm>
#include <cmath>

#include "../records/gauge_report.h"
#include "../records/record_notes.h"
#include "upbead/response/wave_resolution.h"

namespace upbead {

std::optional<double> passing_time(const CompiledCase& scene) {
  const double duration = shortest_duration(scene.scene);
  if (!scene.scene.time.inertia || !std::isfinite(duration)) return std::nullopt;
  double time = duration;
  if (scene.compiled.caisson)
    for (const WaveResolution& at :
         wave_resolution(scene.scene, *scene.mesh, *scene.compiled.caisson, duration, scene.soil_state))
      time = std::max(time, at.wavelength / at.speed);
  return time > 0. ? std::optional(time) : std::nullopt;
}

NumberedWarnings scene_warnings(const Case& input, const CompiledCase& scene, const std::optional<double>& peak_time) {
  NumberedWarnings all;
  for (const NumberedWarnings& part :
       {step_warnings(scene), jump_warnings(scene), mesh_warnings(scene), wall_warnings(scene, peak_time),
        load_warnings(scene), skin_warnings(scene), ring_warnings(scene), slow_wave_warnings(scene),
        layer_warnings(scene), thin_layer_warnings(scene), history_warnings(input), gauge_warnings(input, scene),
        zero_load_warnings(input), record_notes(input).warnings})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace upbead
