// Do the loads fit the curves that they act on?
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "checker.h"

namespace upbead {

namespace {

/// Extent in height of the faces that a load on this curve acts on (m).
Extent extent_of(const Checker& checker, const std::string& curve) {
  Extent extent;
  for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (checker.mesh.curve_of(face) == curve)
        for (unsigned v = 0; v < 2; ++v) extent.add(face->vertex(v));
  return extent;
}

/// The table of a case that the load of that name comes from.
std::string table_of(const std::string& name, const Load& load) {
  const std::size_t suffix = load.transducer.empty() ? 0 : load.transducer.size() + 1;
  return "loads." + name.substr(0, name.size() - suffix);
}

void check_shape(Checker& checker, const std::string& table, const Load& load) {
  const std::string key = table + (load.transducer.empty() ? ".shape" : ".heights");
  const Extent extent = extent_of(checker, load.boundary);
  if (extent.highest - extent.lowest <= 1e-9 * std::max(std::abs(extent.highest), 1.)) {
    checker.object(
        key,
        "the shape runs over the height y, but '" + load.boundary + "' lies at y = " + significant(extent.lowest, 6),
        load.transducer.empty() ? "remove it" : "name the curve of the wall");
    return;
  }
  if (load.shape.back()[0] <= extent.lowest || load.shape.front()[0] >= extent.highest) {
    checker.object(key,
                   (load.transducer.empty() ? "no height of the shape lies on '"
                                            : "transducer '" + load.transducer + "' presses on no height of '") +
                       load.boundary + "', which reaches from y = " + significant(extent.lowest, 6) + " to " +
                       significant(extent.highest, 6),
                   "give heights in the mesh's coordinates");
    return;
  }
  constexpr int n = 1000;
  double total = 0., size = 0.;
  for (int i = 0; i < n; ++i) {
    const double value = intensity(load, extent.lowest + (i + 0.5) / n * (extent.highest - extent.lowest));
    total += value;
    size += std::abs(value);
  }
  if (load.kind == LoadKind::force && std::abs(total) <= 1e-6 * size)
    checker.object(key, "the intensities cancel, so that no resultant force can be spread by them",
                   "use kind = \"traction\"");
}

/// Free water takes a pressure at an open level, and hands it on to what lies under it by itself.
void check_water(Checker& checker, const std::string& table, const Load& load, const Names& behind) {
  for (const std::string& surface : checker.under_water(load.boundary))
    if (load.kind == LoadKind::pressure && checker.is(surface, RegionKind::porous))
      checker.object(table + ".kind",
                     "'" + load.boundary + "' lies under modelled water, whose own pressure acts on '" + surface +
                         "': this load would count it twice",
                     "load the water's open level or the caisson's wall instead, or leave the water out");
  bool only_water = !behind.empty();
  for (const std::string& surface : behind) only_water = only_water && checker.is(surface, RegionKind::water);
  if (!only_water) return;
  const auto side = checker.scene.boundaries.find(load.boundary);
  const bool open = side != checker.scene.boundaries.end() && side->second.pressure == PressureCondition::open;
  if (load.kind != LoadKind::pressure || !open)
    checker.object(table + ".boundary", "behind '" + load.boundary + "' there is only water",
                   "write kind = \"pressure\" here and pressure = \"open\" in [boundaries." + load.boundary + "]");
}

}  // namespace

void check_loads(Checker& checker) {
  for (const auto& [name, load] : checker.scene.loads) {
    if (load.boundary.empty()) continue;
    const std::string table = table_of(name, load);
    const auto curve = checker.outline.outer.find(load.boundary);
    const bool outer = curve != checker.outline.outer.end();
    if (!outer && checker.under_water(load.boundary).empty()) {
      Names names;
      for (const auto& entry : checker.outline.outer) names.insert(entry.first);
      checker.object(table + ".boundary", "the mesh has no outer curve '" + load.boundary + "'",
                     "its outer curves are: " + list(names));
      continue;
    }
    check_water(checker, table, load, outer ? curve->second.surfaces : Names{});
    if (!load.shape.empty()) check_shape(checker, table, load);
  }
}

}  // namespace upbead
