// Checks that sides let the ground between them move as a shaken base moves it.

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.h"
#include "fem/checker.h"
#include "fem/moving_frame.h"

namespace upbead {

using namespace dealii;

namespace {

bool is_soil(const Checker& checker, const std::string& surface) {
  return checker.is(surface, RegionKind::porous) || checker.is(surface, RegionKind::solid);
}

/// Calls visit(face, curve, surface) for each outer face of soil.
template <class Visit>
void for_each_outer_face_of_soil(const Checker& checker, const Visit& visit) {
  for (const auto& cell : checker.mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (const std::string curve = face->at_boundary() ? checker.mesh.curve_of(face) : "";
          checker.scene.boundaries.count(curve) && is_soil(checker, checker.mesh.surface_of(cell)))
        visit(face, curve, checker.mesh.surface_of(cell));
}

bool is_moved(const Scene& scene, const std::string& curve) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const auto& entry) {
    return is_motion(entry.second.kind) && entry.second.factor != 0. && entry.second.boundary == curve;
  });
}

/// Whether a load shakes a base as a whole: a curve along the foot of the ground, moved without a shape.
bool shakes_base(const Checker& checker, const Load& load) {
  if (!is_motion(load.kind) || load.factor == 0. || !load.shape.empty() || !checker.scene.time.inertia) return false;
  const auto& outer = checker.outline.outer;
  const auto own = outer.find(load.boundary);
  if (own == outer.end()) return false;
  const Bounds& bounds = own->second.bounds;
  return bounds.right - bounds.left > bounds.highest - bounds.lowest &&
         std::none_of(outer.begin(), outer.end(),
                      [&](const auto& entry) { return entry.second.bounds.lowest < bounds.lowest; });
}

/// Sides at rest that hold the ground along the motion of the base.
void check_holding_sides(Checker& checker, const Load& load) {
  using D = DisplacementCondition;
  std::map<std::string, D> holding;
  const auto& base = checker.outline.outer.at(load.boundary).bounds;
  for_each_outer_face_of_soil(checker, [&](const auto& face, const std::string& curve, const std::string&) {
    const D condition = checker.scene.boundaries.at(curve).displacement;
    if ((condition != D::fixed && condition != D::roller) || is_moved(checker.scene, curve)) return;
    const auto along = (face->vertex(1) - face->vertex(0)) / face->measure();
    const double normal = std::abs(along[1] * load.direction[0] - along[0] * load.direction[1]);
    const bool upright = std::abs(along[1]) > 0.5 && face->center()[1] > base.lowest;
    if (upright && (condition == D::fixed || normal > 1e-6)) holding.emplace(curve, condition);
  });
  for (const auto& [curve, condition] : holding)
    checker.object(
        "boundaries." + curve + ".displacement",
        "'" + load.boundary + "' is shaken, and '" + curve + "' beside it is " +
            (condition == D::fixed ? "fixed" : "a roller") + " at rest, which holds the ground back along that motion",
        "say \"level\", as the side of level ground without end, or move it as the base by a load of its own");
}

/// A piece of a level side: from its foot (m), and of what ground.
struct Layer {
  std::string ground;
  double from, to;
};

/// The layers of one side, joined, from below.
std::vector<Layer> joined(std::vector<Layer> layers) {
  std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.from < b.from; });
  std::vector<Layer> joined;
  for (const Layer& layer : layers)
    if (!joined.empty() && joined.back().ground == layer.ground)
      joined.back().to = layer.to;
    else
      joined.push_back(layer);
  return joined;
}

/// Under shaking along and across both level sides move alike, which is right where they are alike.
void check_alike(Checker& checker) {
  std::vector<Layer> sides[2];
  std::string key;
  bool upright = true;
  const Bounds whole = [&] {
    Bounds bounds;
    for (const auto& [name, curve] : checker.outline.outer) {
      bounds.add({curve.bounds.left, curve.bounds.lowest});
      bounds.add({curve.bounds.right, curve.bounds.highest});
    }
    return bounds;
  }();
  for_each_outer_face_of_soil(checker, [&](const auto& face, const std::string& curve, const std::string& surface) {
    if (checker.scene.boundaries.at(curve).displacement != DisplacementCondition::level) return;
    if (key.empty()) key = "boundaries." + curve + ".displacement";
    const double a = face->vertex(0)[1], b = face->vertex(1)[1], x = face->center()[0];
    const bool landward = x > 0.5 * (whole.left + whole.right);
    upright = upright && std::abs(x - (landward ? whole.right : whole.left)) < 1e-6 * (whole.right - whole.left) &&
              std::abs(face->vertex(1)[0] - face->vertex(0)[0]) < 1e-6 * face->measure();
    sides[landward].push_back({surface, std::min(a, b), std::max(a, b)});
  });
  if (key.empty()) return;
  const std::vector<Layer> left = joined(sides[0]), right = joined(sides[1]);
  const double tolerance = 1e-6 * (whole.highest - whole.lowest);
  const bool alike =
      std::equal(left.begin(), left.end(), right.begin(), right.end(), [&](const Layer& a, const Layer& b) {
        return a.ground == b.ground && std::abs(a.from - b.from) < tolerance && std::abs(a.to - b.to) < tolerance;
      });
  if (upright && alike) return;
  checker.object(key,
                 "the ground is moved horizontally and vertically, and its two level sides have different layers or "
                 "heights, or are not upright at the section's ends: no condition on them is then right for both",
                 "make both sides alike, or run both motions apart");
}

}  // namespace

void check_shaken_sides(Checker& checker) {
  for (const auto& [name, load] : checker.scene.loads)
    if (shakes_base(checker, load)) check_holding_sides(checker, load);
  if (level_sides(checker.scene) == LevelSides::move_alike) check_alike(checker);
}

}  // namespace upbead
