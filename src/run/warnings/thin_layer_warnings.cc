#include <cmath>

#include "base/text.h"
#include "response/thin_layers.h"
#include "scene_warnings.h"

namespace upbead {

NumberedWarnings thin_layer_warnings(const Simulation& simulation) {
  constexpr double least = 1.;  // cells along to the thickness: docs/warnings.md
  if (!simulation.scene.time.inertia || !simulation.compiled->caisson || simulation.accuracy) return {};
  NumberedWarnings list;
  for (const ThinLayer& layer :
       thin_layers(*simulation.space, *simulation.compiled->caisson))
    if (const double n = layer.cells_per_thickness(); n < least)
      list.push_back({"mesh_too_coarse", n, least, "1",
                      "region '" + layer.region + "' is a soft layer of " + significant(layer.thickness, 2) +
                          " m under the caisson with cells up to " + significant(layer.longest, 2) +
                          " m long: what happens at its ends is not resolved, and F_T may err by several percent; "
                          "refine the mesh along it, or write mesh.refine = \"auto\" or accuracy.estimate = true"});
  return list;
}

}  // namespace upbead
