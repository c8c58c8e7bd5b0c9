// What the checks of a scene against its mesh share.
#pragma once

#include <string>
#include <vector>

#include "fem/outline.h"
#include "model/exclusions.h"
#include "upbead/model/scene.h"

namespace upbead {

/// A scene, its mesh, and what is wrong so far.
struct Checker {
  const Scene& scene;
  const Mesh& mesh;
  Outline outline;
  Diagnostics found;

  /// Once: the loads of several transducers may have the same mistake.
  void object(std::string key, std::string what, std::string cure);
  /// What a way that the scene takes cannot do, told at the key that asks for it.
  void refuse(Treatment way, const std::string& key);
  /// Whether the region of that surface is of that kind; false where the case says nothing of it.
  bool is(const std::string& surface, RegionKind kind) const;
  bool has_pore_water(const std::string& surface) const;
  /// Surfaces of a curve's faces that lie under free water, without the water's; empty where none do.
  Names under_water(const std::string& curve) const;
  /// Whether the case has a water region that the mesh has no surface for: a sea that is not there.
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
void check_loads(Checker& checker);
void check_volume_loads(Checker& checker);

}  // namespace upbead
