#include "upbead/fem/scene_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "upbead/fem/locate.h"

namespace upbead {

using namespace dealii;

namespace {

using Names = std::set<std::string>;

std::string list(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// An outer curve: the surfaces behind it and its extent in height.
struct OuterCurve {
  Names surfaces;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

/// What the checks need to know of the mesh.
struct Outline {
  Names surfaces;
  std::map<std::string, OuterCurve> outer;
  std::vector<std::pair<std::string, std::string>> contacts;  ///< surfaces that share a face
  Names beside_caisson;  ///< surfaces that the caisson touches elsewhere than at its bottom
};

/// A face of a cell is on its lower side where its middle is not above that of its lowest side.
double lower_side(const Triangulation<dim>::active_cell_iterator& cell) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& face : cell->face_iterators()) lowest = std::min(lowest, face->center()[1]);
  return lowest;
}

Outline outline_of(const Mesh& mesh) {
  Outline outline;
  std::set<std::pair<std::string, std::string>> contacts;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const std::string& surface = mesh.surface_of(cell);
    outline.surfaces.insert(surface);
    for (const unsigned f : cell->face_indices()) {
      if (!cell->at_boundary(f)) {
        const std::string& other = mesh.surface_of(cell->neighbor(f));
        if (surface < other) contacts.emplace(surface, other);
        if (surface == caisson_name && other != surface &&
            cell->face(f)->center()[1] > lower_side(cell) + 1e-9 * cell->diameter())
          outline.beside_caisson.insert(other);
        continue;
      }
      OuterCurve& curve = outline.outer[mesh.curve_of(cell->face(f))];
      curve.surfaces.insert(surface);
      for (unsigned v = 0; v < 2; ++v) {
        curve.lowest = std::min(curve.lowest, cell->face(f)->vertex(v)[1]);
        curve.highest = std::max(curve.highest, cell->face(f)->vertex(v)[1]);
      }
    }
  }
  outline.contacts.assign(contacts.begin(), contacts.end());
  return outline;
}

template <typename Map>
Names keys(const Map& map) {
  Names names;
  for (const auto& entry : map) names.insert(entry.first);
  return names;
}

class Checker {
 public:
  Checker(const Scene& scene, const Mesh& mesh) : scene_(scene), mesh_(mesh), outline_(outline_of(mesh)) {}

  std::vector<Objection> run() {
    check_regions();
    check_caisson();
    check_boundaries();
    check_loads();
    check_probes();
    return std::move(objections_);
  }

 private:
  void object(std::string key, std::string what, std::string cure) {
    objections_.push_back({std::move(key), std::move(what), std::move(cure)});
  }

  bool is(const std::string& surface, RegionKind kind) const {
    const auto region = scene_.regions.find(surface);
    return region != scene_.regions.end() && region->second.kind == kind;
  }

  void check_regions() {
    for (const std::string& surface : outline_.surfaces)
      if (!scene_.regions.count(surface))
        object("regions", "the mesh has a surface '" + surface + "' but the case says nothing of it",
               "add a table [regions." + surface + "]");
    for (const auto& region : scene_.regions)
      if (!outline_.surfaces.count(region.first))
        object("regions." + region.first, "the mesh has no surface '" + region.first + "'",
               "its surfaces are: " + list(outline_.surfaces));
    for (const auto& [a, b] : outline_.contacts)
      if (is(a, RegionKind::rigid) && is(b, RegionKind::rigid))
        object("regions." + b + ".kind", "the rigid regions '" + a + "' and '" + b + "' touch",
               "make them one surface in the mesh, or one of them solid");
  }

  /// F_T is read at the caisson's bottom: nothing else may hold it or take part of its force.
  void check_caisson() {
    const auto caisson = scene_.regions.find(caisson_name);
    if (caisson == scene_.regions.end()) return;
    if (caisson->second.kind == RegionKind::porous)
      object("regions.caisson.kind", "the caisson cannot be porous",
             "say \"rigid\" or \"solid\", or give the region another name");
    if (caisson->second.damping)
      object("regions.caisson.damping", "damping of the caisson would take part of the wave force before F_T is read",
             "remove it; damp the ground instead");
    for (const std::string& surface : outline_.beside_caisson)
      object("regions.caisson", "the caisson touches '" + surface + "' elsewhere than at its bottom, where F_T is read",
             "leave a gap, or make '" + surface + "' part of the surface caisson");
    for (const auto& [name, curve] : outline_.outer)
      if (const auto boundary = scene_.boundaries.find(name);
          is(caisson_name, RegionKind::solid) && curve.surfaces.count(caisson_name) &&
          boundary != scene_.boundaries.end() && boundary->second.displacement != DisplacementCondition::free)
        object("boundaries." + name + ".displacement", "a support of the caisson would take part of the shear force",
               "say \"free\"");
  }

  void check_boundaries() {
    const Names outer = keys(outline_.outer);
    for (const std::string& curve : outer)
      if (!scene_.boundaries.count(curve))
        object("boundaries", "the outer curve '" + curve + "' of the mesh has no condition",
               "add a table [boundaries." + curve + "]");
    for (const auto& [name, boundary] : scene_.boundaries) {
      if (!outline_.outer.count(name)) {
        const bool inside = std::count(mesh_.curves.begin(), mesh_.curves.end(), name) > 0;
        object("boundaries." + name,
               inside ? "the curve '" + name + "' lies inside the mesh, where nothing is to be prescribed"
                      : "the mesh has no outer curve '" + name + "'",
               "its outer curves are: " + list(outer));
        continue;
      }
      check_boundary("boundaries." + name, boundary, outline_.outer.at(name));
    }
  }

  void check_boundary(const std::string& key, const Boundary& boundary, const OuterCurve& curve) {
    bool known = true, soil = false, water = false;
    for (const std::string& surface : curve.surfaces) {
      known = known && scene_.regions.count(surface) > 0;
      soil = soil || is(surface, RegionKind::porous);
      water = water || (is(surface, RegionKind::porous) && scene_.regions.at(surface).flow != Flow::drained);
      if (is(surface, RegionKind::rigid) && boundary.displacement != DisplacementCondition::free)
        object(key + ".displacement", "a rigid region ('" + surface + "') cannot be held at a part of its side",
               "say \"free\", or make the region solid");
    }
    if (water && !boundary.pressure)
      object(key, "there is pore water behind this boundary but no condition for its pressure",
             "add pressure = \"sealed\" or pressure = \"open\"");
    if (known && !soil && boundary.pressure)
      object(key + ".pressure", "there is no pore water behind this boundary", "remove the key");
  }

  void check_loads() {
    for (const auto& [name, load] : scene_.loads) {
      if (load.boundary.empty()) continue;
      const auto curve = outline_.outer.find(load.boundary);
      if (curve == outline_.outer.end()) {
        object("loads." + name + ".boundary", "the mesh has no outer curve '" + load.boundary + "'",
               "its outer curves are: " + list(keys(outline_.outer)));
        continue;
      }
      if (!load.shape.empty()) check_shape(name, load, curve->second);
    }
  }

  void check_shape(const std::string& name, const Load& load, const OuterCurve& curve) {
    const std::string key = "loads." + name + ".shape";
    if (curve.highest - curve.lowest <= 1e-9 * std::max(std::abs(curve.highest), 1.)) {
      object(key, "the shape runs over the height y, but '" + load.boundary + "' lies at y = " + number(curve.lowest),
             "remove it");
      return;
    }
    if (load.shape.back()[0] <= curve.lowest || load.shape.front()[0] >= curve.highest) {
      object(key,
             "no height of the shape lies on '" + load.boundary + "', which reaches from y = " + number(curve.lowest) +
                 " to " + number(curve.highest),
             "give heights in the mesh's coordinates");
      return;
    }
    constexpr int n = 1000;
    double total = 0., size = 0.;
    for (int i = 0; i < n; ++i) {
      const double value = intensity(load, curve.lowest + (i + 0.5) / n * (curve.highest - curve.lowest));
      total += value;
      size += std::abs(value);
    }
    if (load.kind == LoadKind::force && std::abs(total) <= 1e-6 * size)
      object(key, "the intensities cancel, so that no resultant force can be spread by them",
             "use kind = \"traction\"");
  }

  void check_probes() {
    for (const auto& [name, probe] : scene_.probes) {
      const Point<dim> at(probe.at[0], probe.at[1]);
      bool inside = false;
      for (const auto& cell : mesh_.triangulation.active_cell_iterators())
        inside = inside || unit_coordinates(cell, at).has_value();
      if (!inside)
        object("probes." + name + ".at", "the point (" + number(at[0]) + ", " + number(at[1]) + ") is outside the mesh",
               "give a point of the section, in metres");
    }
  }

  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
  }

  const Scene& scene_;
  const Mesh& mesh_;
  Outline outline_;
  std::vector<Objection> objections_;
};

}  // namespace

std::vector<Objection> check_scene(const Scene& scene, const Mesh& mesh) {
  return Checker(scene, mesh).run();
}

}  // namespace upbead
