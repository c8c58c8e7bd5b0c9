// Checks that the conditions on boundaries, and the loads, suit the regions behind them.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "fem/checker.h"
#include "fem/curve_course.h"
#include "fem/moving_frame.h"

namespace upbead {

using namespace dealii;

namespace {

/// The kinds of region beside an outer curve.
struct AdjacentRegions {
  bool known = true, soil = false, pore_water = false, free_water = false, only_free_water = true;
  std::string rigid;  ///< name of a rigid region; "" where there is none
};

AdjacentRegions adjacent_regions(const Checker& checker, const OuterCurve& curve) {
  AdjacentRegions found;
  for (const std::string& surface : curve.surfaces) {
    const bool water = checker.is(surface, RegionKind::water);
    found.known = found.known && checker.scene.regions.count(surface) > 0;
    found.soil = found.soil || checker.is(surface, RegionKind::porous);
    found.pore_water = found.pore_water || checker.has_pore_water(surface);
    found.free_water = found.free_water || water;
    found.only_free_water = found.only_free_water && water;
    if (checker.is(surface, RegionKind::rigid)) found.rigid = surface;
  }
  return found;
}

/// A rigid plate must be straight.
void check_straight(Checker& checker, const std::string& key) {
  const std::string curve = key.substr(key.find('.') + 1);
  std::optional<Tensor<1, dim>> first;
  for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || checker.mesh.curve_of(face) != curve) continue;
      const Tensor<1, dim> along = (face->vertex(1) - face->vertex(0)) / face->measure();
      if (!first) first = along;
      if (std::abs((*first)[0] * along[1] - (*first)[1] * along[0]) <= 1e-6) continue;
      checker.object(key + ".displacement", "a rigid plate lies on a straight side, and '" + curve + "' bends",
                     "divide the curve in the mesh, or say \"roller\" or \"free\"");
      return;
    }
}

/// Springs and dashpots need a region that deforms.
void check_springs(Checker& checker, const std::string& key, const Boundary& side, const AdjacentRegions& at) {
  for (const auto& [name, given] : {std::pair{"spring", side.spring}, std::pair{"dashpot", side.dashpot}}) {
    if (!given) continue;
    if (!at.rigid.empty())
      checker.object(key + "." + name, "a rigid region ('" + at.rigid + "') cannot be held at a part of its side",
                     "remove it, or make the region solid");
    if (at.known && at.only_free_water)
      checker.object(key + "." + name, "there is only water behind this boundary, which nothing holds", "remove it");
  }
}

void check_displacement(Checker& checker, const std::string& key, const Boundary& side, const AdjacentRegions& at) {
  using D = DisplacementCondition;
  if (side.displacement == D::free) return;
  if (!at.rigid.empty())
    checker.object(key + ".displacement", "a rigid region ('" + at.rigid + "') cannot be held at a part of its side",
                   "say \"free\", or make the region solid");
  if (at.known && at.only_free_water)
    checker.object(key + ".displacement", "there is only water behind this boundary, which nothing holds",
                   "remove the key");
  if (side.displacement == D::plate) check_straight(checker, key);
  if (side.displacement != D::absorbing) return;
  if (!checker.scene.time.inertia) checker.refuse(Treatment::consolidation, key + ".displacement");
  if (at.pore_water && std::isinf(checker.scene.fluid.bulk_modulus))
    checker.object(
        key + ".displacement",
        "in soil full of incompressible water (fluid.bulk_modulus = inf) pressure waves have no finite speed "
        "that a side could be tuned to",
        "say \"roller\" with pressure = \"sealed\", or give a bulk modulus");
}

void check_pressure(Checker& checker, const std::string& key, const Boundary& side, const AdjacentRegions& at) {
  using P = PressureCondition;
  if (!side.pressure) {
    if (at.pore_water || at.free_water)
      checker.object(key,
                     std::string("there is ") + (at.pore_water ? "pore water" : "water") +
                         " behind this boundary but no condition for its pressure",
                     "add pressure = \"sealed\" or pressure = \"open\"");
    return;
  }
  if (at.known && !at.soil && !at.free_water)
    checker.object(key + ".pressure", "there is no pore water behind this boundary", "remove the key");
  if (*side.pressure == P::surface_waves && !at.only_free_water)
    checker.object(key + ".pressure", "surface waves need a level of free water", "say \"open\" or \"sealed\"");
  if (*side.pressure != P::absorbing) return;
  if (at.pore_water && side.displacement == DisplacementCondition::free)
    checker.object(key + ".displacement", "pores that absorb waves need a skeleton that is held or absorbs them too",
                   "say displacement = \"absorbing\"");
  if (!checker.scene.time.inertia) checker.refuse(Treatment::consolidation, key + ".pressure");
  if (std::isinf(checker.scene.fluid.bulk_modulus))
    checker.object(key + ".pressure",
                   "incompressible water (fluid.bulk_modulus = inf) carries no pressure waves to absorb",
                   "say \"sealed\", and let the water reach three depths away");
}

/// How supports hold the three rigid-body motions of the scene: the sum of c c^T over the directions d that they hold
/// at points (x, y); c holds the components of the unit motions along d.
Eigen::Matrix3d held_motions(const Checker& checker) {
  using D = DisplacementCondition;
  Eigen::Matrix3d held = Eigen::Matrix3d::Zero();
  const auto& first = checker.mesh.triangulation.get_vertices().front();
  for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      const auto side = checker.scene.boundaries.find(checker.mesh.curve_of(face));
      if (!face->at_boundary() || side == checker.scene.boundaries.end()) continue;
      const D condition = side->second.displacement;
      const bool level = condition == D::level, sprung = side->second.spring && condition == D::free;
      if ((condition != D::fixed && condition != D::roller && !level && !sprung) ||
          checker.is(checker.mesh.surface_of(cell), RegionKind::water))
        continue;
      const auto along = (face->vertex(1) - face->vertex(0)) / face->measure();
      for (unsigned v = 0; v < 2; ++v) {
        const auto at = (face->vertex(v) - first) / face->measure();
        const Eigen::Vector3d normal(along[1], -along[0], along[1] * at[1] + along[0] * at[0]);
        const Eigen::Vector3d tangent(along[0], along[1], along[0] * at[1] - along[1] * at[0]);
        const Eigen::Vector3d across = level_sides(checker.scene) == LevelSides::hold_horizontally
                                           ? Eigen::Vector3d(1., 0., at[1])
                                           : Eigen::Vector3d(0., 1., -at[0]);
        const bool along_normal = sprung ? (*side->second.spring)[0] > 0. : !level;
        const bool along_tangent = sprung ? (*side->second.spring)[1] > 0. : condition == D::fixed;
        if (level) held += across * across.transpose();
        if (along_normal) held += normal * normal.transpose();
        if (along_tangent) held += tangent * tangent.transpose();
      }
    }
  return held;
}

/// Without inertia, a scene that can move as a rigid body has no solution.
void check_held(Checker& checker) {
  if (checker.scene.time.inertia) return;
  const Eigen::Vector3d held = held_motions(checker).selfadjointView<Eigen::Lower>().eigenvalues();
  if (held[0] > 1e-10 * held[2] && held[2] > 0.) return;
  checker.object(
      "boundaries",
      "without inertia (time.inertia = false) nothing holds the scene: as one body it may shift or turn freely",
      "say displacement = \"fixed\" at its base, or \"roller\" at base and sides");
}

}  // namespace

void check_boundaries(Checker& checker) {
  check_held(checker);
  const auto& outer = checker.outline.outer;
  for (const auto& [name, curve] : outer)
    if (!checker.scene.boundaries.count(name))
      checker.object("boundaries", "the outer curve '" + name + "' of the mesh has no condition",
                     "add a table [boundaries." + name + "]");
  const bool lacks_a_sea = checker.lacks_a_sea();
  for (const auto& [name, side] : checker.scene.boundaries) {
    const std::string key = "boundaries." + name;
    if (const auto curve = outer.find(name); curve != outer.end()) {
      const AdjacentRegions at = adjacent_regions(checker, curve->second);
      check_displacement(checker, key, side, at);
      check_springs(checker, key, side, at);
      check_pressure(checker, key, side, at);
      continue;
    }
    const auto& curves = checker.mesh.curves;
    const bool inside = std::find(curves.begin(), curves.end(), name) != curves.end();
    if (!checker.under_water(name).empty() || (!inside && lacks_a_sea)) continue;
    checker.object(key,
                   inside ? "the curve '" + name + "' lies inside the mesh, where nothing is to be prescribed"
                          : "the mesh has no outer curve '" + name + "'",
                   "its outer curves are: " + list(keys(outer)));
  }
}

namespace {

/// Extent of the faces that a load on this curve acts on (m).
Bounds bounds_of(const Checker& checker, const std::string& curve) {
  Bounds bounds;
  for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (checker.mesh.curve_of(face) == curve)
        for (unsigned v = 0; v < 2; ++v) bounds.add(face->vertex(v));
  return bounds;
}

/// The table of the case that defines the load of that name.
std::string table_of(const std::string& name, const Load& load) {
  const std::size_t suffix = load.transducer.empty() ? 0 : load.transducer.size() + 1;
  return "loads." + name.substr(0, name.size() - suffix);
}

/// The key that defines where a load's shape begins and ends.
std::string shape_key(const std::string& table, const Load& load) {
  return table + (load.transducer.empty() ? ".shape" : ".heights");
}

/// Whether the curve has an extent along the shape's axis, and the shape covers a part of it.
bool check_extent(Checker& checker, const std::string& table, const Load& load, double from, double to) {
  const std::string key = shape_key(table, load), axis = load.over_x ? "x" : "y";
  if (to - from <= 1e-9 * std::max(std::abs(to), 1.)) {
    checker.object(key,
                   "the shape runs over " + std::string(load.over_x ? "x" : "the height y") + ", but '" +
                       load.boundary + "' lies at " + axis + " = " + significant(from, 6),
                   load.transducer.empty() ? "remove it, or give over" : "name the curve of the wall");
    return false;
  }
  if (load.shape.back()[0] > from && load.shape.front()[0] < to) return true;
  checker.object(
      key,
      (load.transducer.empty()
           ? "no " + std::string(load.over_x ? "place" : "height") + " of the shape lies on '"
           : "transducer '" + load.transducer + "' presses on no " + (load.over_x ? "place" : "height") + " of '") +
          load.boundary + "', which reaches from " + axis + " = " + significant(from, 6) + " to " + significant(to, 6),
      "give " + std::string(load.over_x ? "places" : "heights") + " in the mesh's coordinates");
  return false;
}

/// Whether lengths along the curve are defined, and those given lie on it.
void check_along(Checker& checker, const std::string& table, const Load& load) {
  const auto course = course_of(checker.mesh, load.boundary);
  if (course.empty()) {
    checker.object(table + ".along_curve",
                   "'" + load.boundary +
                       "' is not one open line, so that it has no length to "
                       "count along",
                   "divide the curve in the mesh, or give heights y or places x");
    return;
  }
  double length = 0.;
  for (std::size_t i = 1; i < course.size(); ++i)
    length += std::hypot(course[i][0] - course[i - 1][0], course[i][1] - course[i - 1][1]);
  if (load.shape.back()[0] > 0. && load.shape.front()[0] < length) return;
  checker.object(
      shape_key(table, load),
      "no length of the shape lies on '" + load.boundary + "', which is " + significant(length, 6) + " m long",
      "give lengths from the curve's seaward end");
}

void check_shape(Checker& checker, const std::string& table, const Load& load) {
  if (load.along_curve) return check_along(checker, table, load);
  const Bounds bounds = bounds_of(checker, load.boundary);
  const double from = load.over_x ? bounds.left : bounds.lowest, to = load.over_x ? bounds.right : bounds.highest;
  if (!check_extent(checker, table, load, from, to)) return;
  constexpr int n = 1000;
  double total = 0., size = 0.;
  for (int i = 0; i < n; ++i) {
    const double value = intensity(load, from + (i + 0.5) / n * (to - from));
    total += value;
    size += std::abs(value);
  }
  if (load.kind == LoadKind::force && std::abs(total) <= 1e-6 * size)
    checker.object(shape_key(table, load), "the intensities cancel, so that no resultant force can be spread by them",
                   "use kind = \"traction\"");
}

/// Free water takes a pressure only at an open level; it passes the pressure on to the surfaces below by itself.
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
    if (load.boundary.empty() || is_on_volume(load.kind)) continue;
    const std::string table = table_of(name, load);
    const auto curve = checker.outline.outer.find(load.boundary);
    const bool outer = curve != checker.outline.outer.end();
    if (!outer && checker.under_water(load.boundary).empty()) {
      checker.object(table + ".boundary", "the mesh has no outer curve '" + load.boundary + "'",
                     "its outer curves are: " + list(keys(checker.outline.outer)));
      continue;
    }
    check_water(checker, table, load, outer ? curve->second.surfaces : Names{});
    if (!load.shape.empty()) check_shape(checker, table, load);
  }
}

}  // namespace upbead
