#include "checker.h"

namespace upbead {

void Checker::object(std::string key, std::string what, std::string cure) {
  for (const Diagnostic& known : found)
    if (known.place.key == key && known.what == what) return;
  found.add(at_key(std::move(key)), std::move(what), std::move(cure));
}

void Checker::refuse(Treatment way, const std::string& key) {
  for (const Exclusion& reason : excluded(scene, way))
    if (reason.key == key) object(key, reason.why, reason.cure);
}

bool Checker::is(const std::string& surface, RegionKind kind) const {
  const auto region = scene.regions.find(surface);
  return region != scene.regions.end() && region->second.kind == kind;
}

bool Checker::has_pore_water(const std::string& surface) const {
  return is(surface, RegionKind::porous) && scene.regions.at(surface).flow != Flow::drained;
}

Names Checker::under_water(const std::string& curve) const {
  Names surfaces;
  const auto inner = outline.inner.find(curve);
  if (inner == outline.inner.end()) return surfaces;
  for (const auto& [a, b] : inner->second) {
    if (is(a, RegionKind::water) && !is(b, RegionKind::water)) surfaces.insert(b);
    if (is(b, RegionKind::water) && !is(a, RegionKind::water)) surfaces.insert(a);
  }
  return surfaces;
}

bool Checker::lacks_a_sea() const {
  for (const auto& [name, region] : scene.regions)
    if (region.kind == RegionKind::water && !outline.surfaces.count(name)) return true;
  return false;
}

std::string list(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace upbead
