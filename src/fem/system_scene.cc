#include "fem/system_scene.h"

#include <algorithm>

#include "model/equal.h"

namespace upbead {

namespace {

Load without_course(Load load) {
  load.history = TimeFunction();
  load.duration.reset();
  load.factor = load.factor == 0. ? 0. : 1.;
  return load;
}

bool same_loads(const std::map<std::string, Load>& a, const std::map<std::string, Load>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.first == other.first && one.second.factor == other.second.factor &&
           place_of(one.second) == place_of(other.second);
  });
}

}  // namespace

SystemScene system_scene(const Scene& scene) {
  SystemScene part{scene.gravity, scene.fluid,  scene.mesh.degree, scene.regions,     scene.boundaries,
                   scene.loads,   scene.probes, scene.base_stress, scene.time.inertia};
  for (auto& [name, load] : part.loads) load = without_course(load);
  for (auto& [name, region] : part.regions)
    if (region.interface) region.interface->coefficient.reset();  // of the law, which the equations do not hold
  return part;
}

Scene as_scene(const SystemScene& part) {
  Scene scene;
  scene.gravity = part.gravity;
  scene.fluid = part.fluid;
  scene.mesh.degree = part.degree;
  scene.regions = part.regions;
  scene.boundaries = part.boundaries;
  scene.loads = part.loads;
  scene.probes = part.probes;
  scene.base_stress = part.base_stress;
  scene.time.inertia = part.inertia;
  return scene;
}

bool operator==(const SystemScene& a, const SystemScene& b) {
  const auto& [gravity, fluid, degree, regions, boundaries, loads, probes, base_stress, inertia] = a;
  return gravity == b.gravity && fluid == b.fluid && degree == b.degree && regions == b.regions &&
         boundaries == b.boundaries && same_loads(loads, b.loads) && probes == b.probes &&
         base_stress == b.base_stress && inertia == b.inertia;
}

}  // namespace upbead
