#include "upbead/fem/scene_check.h"

#include <algorithm>
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
};

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
      const auto& shape = load.shape;
      if (!shape.empty() && (shape.back()[0] <= curve->second.lowest || shape.front()[0] >= curve->second.highest))
        object("loads." + name + ".shape",
               "no height of the shape lies on '" + load.boundary +
                   "', which reaches from y = " + number(curve->second.lowest) + " to " + number(curve->second.highest),
               "give heights in the mesh's coordinates");
    }
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
