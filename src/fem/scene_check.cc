#include "fem/scene_check.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "fem/caisson/bottom.h"
#include "fem/caisson/springs.h"
#include "fem/checker.h"
#include "fem/outline.h"
#include "fem/static_stage.h"
#include "fem/surcharge.h"

namespace upbead {

using namespace dealii;

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

namespace {

void check_regions(Checker& checker) {
  const auto& surfaces = checker.outline.surfaces;
  for (const auto& [surface, bounds] : surfaces)
    if (!checker.scene.regions.count(surface))
      checker.object("regions", "the mesh has a surface '" + surface + "' but the case says nothing of it",
                     "add a table [regions." + surface + "]");
  for (const auto& [name, region] : checker.scene.regions) {
    if (!surfaces.count(name) && region.kind != RegionKind::water)
      checker.object("regions." + name, "the mesh has no surface '" + name + "'",
                     "its surfaces are: " + list(keys(surfaces)));
    if (surfaces.count(name) && region.kind == RegionKind::water && !checker.scene.time.inertia)
      checker.refuse(Treatment::consolidation, "regions." + name + ".kind");
  }
  for (const auto& [a, b] : checker.outline.contacts)
    if (checker.is(a, RegionKind::rigid) && checker.is(b, RegionKind::rigid))
      checker.object("regions." + b + ".kind", "the rigid regions '" + a + "' and '" + b + "' touch",
                     "make them one surface in the mesh, or one of them solid");
}

/// A surcharge must lie on ground at some place.
void check_surcharge(Checker& checker, const std::string& name, const Surcharge& surcharge) {
  const std::string key = "initial.surcharge." + name;
  if (surcharge.from && surcharge.to && *surcharge.from >= *surcharge.to) {
    checker.object(key + ".from",
                   "from = " + significant(*surcharge.from, 6) + " is not below to = " + significant(*surcharge.to, 6),
                   "give from < to");
    return;
  }
  double length = 0.;
  for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      const std::string surface = checker.mesh.surface_of(cell);
      if (checker.mesh.curve_of(cell->face(f)) == surcharge.boundary &&
          (checker.is(surface, RegionKind::porous) || checker.is(surface, RegionKind::solid)))
        length += covered(surcharge, cell->face(f)->vertex(0), cell->face(f)->vertex(1));
    }
  if (!(length > 0.))
    checker.object(key + ".boundary",
                   "no soil lies under the surcharge '" + name + "' on the curve '" + surcharge.boundary + "'",
                   "name a curve of the ground's surface, and x of its ends upon it");
}

/// Still water at two levels acts on a rigid caisson before the wave.
void check_harbour(Checker& checker) {
  if (!checker.scene.initial || !checker.scene.initial->harbour_level) return;
  const std::string key = "initial.harbour_level";
  if (!checker.scene.initial->water_level)
    checker.object(key, "the harbour has a level, and the sea has none",
                   "add water_level, the height y of still water in front of the caisson (m)");
  if (!checker.is(caisson_name, RegionKind::rigid))
    checker.object(key, "still water at two levels acts on a rigid caisson, and there is none",
                   "write [regions.caisson] kind = \"rigid\", or give one level");
}

/// Weights in still water need a water level.
void check_initial(Checker& checker) {
  if (checker.scene.initial)
    for (const auto& [name, surcharge] : checker.scene.initial->surcharge) check_surcharge(checker, name, surcharge);
  const bool asked = checker.scene.initial && checker.scene.initial->safety;
  const Limits& limits = checker.scene.limits;
  const bool safety = asked || limits.safety || limits.peak_safety;
  const std::string key = asked ? "initial.safety" : limits.safety ? "limits.safety" : "limits.peak_safety";
  const auto& regions = checker.scene.regions;
  if (safety &&
      std::none_of(regions.begin(), regions.end(), [](const auto& r) { return r.second.strength.has_value(); }))
    checker.object(key, "no region has a strength that may fall",
                   "give soils a table strength, such as strength = { friction_angle = 40 }");
  if (limits.peak_safety && regions.count(caisson_name) == 0)
    checker.object("limits.peak_safety", "no base presses on the ground, as there is no region 'caisson'",
                   "leave that limit out; limits.safety judges the ground at rest");
  const bool built = !checker.scene.construction.empty();
  if ((!needs_static_stage(checker.scene) && !yields(checker.scene) && !safety && !built && !limits.liquefaction) ||
      std::isfinite(water_level(checker.scene, checker.mesh)))
    return;
  checker.object("initial",
                 "stiffness by stress, soil that yields, safety, construction and liquefaction need the level of still "
                 "water, which no region of water gives",
                 "add [initial] with water_level, the height y (m)");
}

/// The caisson may not be soil that yields: readings along its bottom would belong to both sides.
void check_yielding(Checker& checker) {
  const auto caisson = checker.scene.regions.find(caisson_name);
  if (caisson != checker.scene.regions.end() && caisson->second.law != SoilLaw::elastic)
    checker.object("regions.caisson.law", "only soil yields", "write law = \"elastic\"");
}

/// F_T is read at the caisson's bottom: so nothing but water may hold the caisson elsewhere or take a part of its
/// force.
void check_caisson(Checker& checker) {
  const auto caisson = checker.scene.regions.find(caisson_name);
  if (caisson == checker.scene.regions.end()) return;
  const RegionKind kind = caisson->second.kind;
  if (kind == RegionKind::porous || kind == RegionKind::water)
    checker.object("regions.caisson.kind",
                   std::string("the caisson cannot be ") + (kind == RegionKind::porous ? "porous" : "water"),
                   "say \"rigid\" or \"solid\", or give the region another name");
  if (caisson->second.damping)
    checker.object("regions.caisson.damping",
                   "damping of the caisson would take part of the wave force before F_T is read",
                   "remove it; damp the ground instead");
  for (const std::string& surface : checker.outline.beside_caisson)
    if (!checker.is(surface, RegionKind::water))
      checker.object("regions.caisson",
                     "the caisson touches '" + surface + "' elsewhere than at its bottom, where F_T is read",
                     "leave a gap, or make '" + surface + "' part of the surface caisson");
  for (const auto& [name, curve] : checker.outline.outer)
    if (const auto boundary = checker.scene.boundaries.find(name);
        kind == RegionKind::solid && curve.surfaces.count(caisson_name) && boundary != checker.scene.boundaries.end() &&
        boundary->second.displacement != DisplacementCondition::free)
      checker.object("boundaries." + name + ".displacement",
                     "a support of the caisson would take part of the shear force", "say \"free\"");
}

/// What a case may ask of the ground under a caisson, which springs have not.
void check_asked_of_ground(Checker& checker) {
  const Scene& scene = checker.scene;
  const auto refuse = [&](bool asked, const std::string& key, const std::string& what, const std::string& cure) {
    if (asked) checker.object(key, what + ", and springs stand for it", cure);
  };
  refuse(scene.base_stress, "output.base", "the stress along the base is that of the ground's nodes",
         "leave it out: normal_force and base_moment tell what presses on the springs");
  refuse(!scene.construction.empty(), "construction", "stages build the ground", "remove them, or mesh the ground");
  refuse(scene.limits.circles.has_value(), "limits.circles", "slip circles pass through ground", "remove it");
  refuse(scene.limits.liquefaction.has_value(), "limits.liquefaction", "it is the ground that liquefies", "remove it");
  refuse(scene.cycles.has_value(), "cycles", "cycles of a storm build pore pressure in ground", "remove it");
}

/// Springs under the caisson, and nothing else.
void check_base_springs(Checker& checker) {
  for (const auto& [name, region] : checker.scene.regions)
    if (region.springs && name != caisson_name)
      checker.object("regions." + name + ".springs", "only the caisson may stand on springs",
                     "name the region 'caisson', or give a side of the mesh springs: [boundaries.NAME] spring");
  const auto caisson = checker.scene.regions.find(caisson_name);
  if (caisson == checker.scene.regions.end() || !caisson->second.springs) return;
  const std::string key = "regions.caisson.springs";
  for (const std::string& surface : checker.outline.touching(caisson_name))
    if (!checker.is(surface, RegionKind::water))
      checker.object(key, "the caisson stands on '" + surface + "' and on springs",
                     "take a mesh without ground, such as geometry = \"caisson\", or remove the springs");
  if (checker.outline.surfaces.count(caisson_name) && !lowest_side(checker.mesh))
    checker.object(key, "the caisson's lowest side is not level, or lies inside the mesh",
                   "level it in the mesh, as in geometry = \"caisson\"");
  if (!checker.scene.time.inertia) checker.refuse(Treatment::consolidation, key);
  check_asked_of_ground(checker);
}

/// Whether a pressure on that curve is that of pore water, too.
bool wets_pores(const Checker& checker, const std::string& curve) {
  const auto outer = checker.outline.outer.find(curve);
  const auto side = checker.scene.boundaries.find(curve);
  if (outer == checker.outline.outer.end() || side == checker.scene.boundaries.end()) return false;
  const Names& behind = outer->second.surfaces;
  return side->second.pressure == PressureCondition::open &&
         std::any_of(behind.begin(), behind.end(),
                     [&](const std::string& name) { return checker.has_pore_water(name); });
}

/// Only a rigid caisson on a level bottom may slip, and only in a march in time.
void check_contact(Checker& checker) {
  for (const auto& [name, region] : checker.scene.regions)
    if (region.interface && name != caisson_name)
      checker.object("regions." + name + ".interface", "only the caisson has an interface", "remove it");
  if (!has_frictional_contact(checker.scene)) return;
  const std::string key = "regions.caisson.interface";
  for (const Exclusion& reason : excluded(checker.scene, Treatment::contact))
    checker.object(key, reason.why, reason.cure);
  if (!bottom_is_level(checker.mesh))
    checker.object(key, "the caisson's bottom is not level", "write kind = \"bonded\", or level it in the mesh");
  if (checker.scene.regions.at(caisson_name).interface->gap != GapSource::sea) return;
  for (const auto& [name, load] : checker.scene.loads)
    if (load.kind == LoadKind::pressure && load.factor != 0. && wets_pores(checker, load.boundary))
      checker.object(key + ".gap",
                     "the load '" + name + "' sets the pressure of pore water on '" + load.boundary +
                         "', from where gaps take it: the sea in gaps would count it twice",
                     "write gap = \"pores\"");
}

void check_probes(Checker& checker) {
  for (const auto& [name, probe] : checker.scene.probes) {
    const Point<dim> at(probe.at[0], probe.at[1]);
    bool inside = false;
    for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
      inside = inside || unit_coordinates(cell, at).has_value();
    if (!inside)
      checker.object("probes." + name + ".at", "the point " + place_text(at, 6) + " is outside the mesh",
                     "give a point of the section, in metres");
  }
}

}  // namespace

Diagnostics check_scene(const Scene& scene, const Mesh& mesh) {
  Checker checker{scene, mesh, outline_of(mesh), {}};
  check_regions(checker);
  check_initial(checker);
  check_construction(checker);
  check_harbour(checker);
  check_yielding(checker);
  check_caisson(checker);
  check_body_parts(checker);
  check_contact(checker);
  check_base_springs(checker);
  check_added_mass(checker);
  check_boundaries(checker);
  check_shaken_sides(checker);
  check_loads(checker);
  check_volume_loads(checker);
  check_probes(checker);
  return std::move(checker.found);
}

}  // namespace upbead
