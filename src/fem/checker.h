// Data and functions that the checks of a scene against its mesh share.
#pragma once

#include <string>
#include <vector>

#include "fem/outline.h"
#include "model/exclusions.h"
#include "upbead/model/scene.h"

namespace upbead {

/// A scene, its mesh, and the mistakes found so far.
struct Checker {
  const Scene& scene;
  const Mesh& mesh;
  Outline outline;
  Diagnostics found;

  /// Reports a mistake, each once: the loads of several transducers may have the same one.
  void object(std::string key, std::string what, std::string cure);
  /// Reports that a way which the scene takes cannot do what `key` asks for.
  void refuse(Treatment way, const std::string& key);
  /// Whether the region of that surface is of that kind; false where the case has no such region.
  bool is(const std::string& surface, RegionKind kind) const;
  bool has_pore_water(const std::string& surface) const;
  /// Surfaces at a curve's faces that lie under free water, without the water itself; empty where there are none.
  Names under_water(const std::string& curve) const;
  /// Whether the case has a water region without a surface in the mesh: a sea that is not modelled.
  bool lacks_a_sea() const;
};

template <typename Value>
Names keys(const std::map<std::string, Value>& map) {
  Names names;
  for (const auto& entry : map) names.insert(entry.first);
  return names;
}

/// "bed, left", or "none".
std::string list(const Names& names);

void check_boundaries(Checker& checker);
void check_shaken_sides(Checker& checker);
void check_loads(Checker& checker);
void check_volume_loads(Checker& checker);
void check_construction(Checker& checker);
void check_body_parts(Checker& checker);
void check_added_mass(Checker& checker);

}  // namespace upbead
