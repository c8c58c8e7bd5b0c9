#include "upbead/model/region.h"

#include <algorithm>

#include "upbead/model/scene.h"

namespace upbead {

namespace {

const ContactLaw* contact_law(const Scene& scene) {
  const auto caisson = scene.regions.find(caisson_name);
  const bool is_free = caisson != scene.regions.end() && caisson->second.interface &&
                       caisson->second.interface->kind == ContactKind::friction;
  return is_free ? &*caisson->second.interface : nullptr;
}

}  // namespace

bool has_prescribed_motion(const Scene& scene) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const auto& entry) {
    const Load& load = entry.second;
    const auto side = scene.boundaries.find(load.boundary);
    return is_motion(load.kind) && load.factor != 0. && side != scene.boundaries.end() &&
           side->second.displacement != DisplacementCondition::absorbing;
  });
}

bool has_frictional_contact(const Scene& scene) {
  return contact_law(scene) != nullptr;
}

bool follows_strain(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return entry.second.strain_law && entry.second.law == SoilLaw::elastic; });
}

bool follows_velocity(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return entry.second.forchheimer.has_value(); });
}

std::vector<std::string> stages_in_order(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& [name, stage] : scene.construction) names.push_back(name);
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return scene.construction.at(a).order < scene.construction.at(b).order;
  });
  return names;
}

bool yields(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return entry.second.law != SoilLaw::elastic; });
}

bool has_strength(const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(),
                     [](const auto& entry) { return entry.second.strength && entry.second.law == SoilLaw::elastic; });
}

bool builds_pressure(const Scene& scene) {
  return scene.cycles && std::any_of(scene.regions.begin(), scene.regions.end(),
                                     [](const auto& entry) { return entry.second.cyclic.has_value(); });
}

double contact_friction(const Scene& scene) {
  constexpr double usual = 0.6;  // of concrete on rubble: Goda (2000), section 4.2
  const ContactLaw* law = contact_law(scene);
  if (law && law->coefficient) return *law->coefficient;
  return scene.sliding ? scene.sliding->friction : usual;
}

}  // namespace upbead
