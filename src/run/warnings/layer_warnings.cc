#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "response/drained_layer.h"
#include "response/step_choice.h"
#include "scene_warnings.h"

namespace upbead {

namespace {

/// Of F_T, where a layer that should not yield yields more than all else: the largest of ten scenes, docs/warnings.md.
constexpr double at_most = 0.25, largest_layer_error = 0.05;

std::string cure(const DrainedLayer& layer, int degree) {
  constexpr double share = largest_layer_error / at_most, ratio = share / (1. - share);
  const double skin = layer.skin / layer.stiffness;  // what it yields by (m/Pa)
  const double cell = degree * (layer.skin + layer.stiffness * layer.of_the_rest * ratio);
  const bool water_stays = skin <= ratio * (layer.of_the_rest - skin);
  return "take cells of at most " + significant(cell, 2) + " m there" +
         (water_stays
              ? ", or, as its water stays, kind = \"solid\" with poissons_ratio = 0.499 and its density with water"
              : "");
}

}  // namespace

NumberedWarnings layer_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene;
  if (!simulation.compiled->caisson || !scene.time.inertia || simulation.accuracy) return {};
  const double duration = step_of_loads(scene, 4).duration;
  const std::optional<DrainedLayer> layer =
      drained_layer(scene, *simulation.space, *simulation.compiled->caisson, 0.5 * duration);
  if (!layer) return {};
  const double error = at_most * layer->share();
  if (error <= largest_layer_error) return {};
  return {{"drained_layer", error, largest_layer_error, "1",
           "water leaves a skin of " + significant(layer->skin, 2) + " m of '" + layer->region + "' into '" +
               layer->into + "' within " + significant(0.5 * duration) + " s, but cells of " +
               significant(layer->cell, 2) + " m drain more, which makes " +
               std::to_string(std::lround(100. * layer->share())) +
               " % of what the ground under the caisson yields by" + ": F_T may err by up to " +
               std::to_string(std::lround(100. * error)) + " %; " + cure(*layer, simulation.space->degree())}};
}

}  // namespace upbead
