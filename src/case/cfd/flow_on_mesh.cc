// Loads of CFD records on the boundaries of a mesh.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "case/cfd/flow_pieces.h"
#include "case/cfd/flow_scene.h"
#include "fem/outline.h"

namespace upbead {

namespace {

using Segment = std::array<dealii::Point<dim>, 2>;

std::vector<Segment> faces_of(const Mesh& mesh, const std::string& curve) {
  std::vector<Segment> faces;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (mesh.curve_of(face) == curve) faces.push_back({face->vertex(0), face->vertex(1)});
  return faces;
}

Bounds bounds_of_faces(const std::vector<Segment>& faces) {
  Bounds bounds;
  for (const Segment& face : faces)
    for (const auto& point : face) bounds.add(point);
  return bounds;
}

double distance_to(const std::vector<Segment>& faces, const dealii::Point<dim>& at) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : faces) {
    const auto along = b - a;
    const double s = std::clamp(((at - a) * along) / along.norm_square(), 0., 1.);
    least = std::min(least, (a + s * along).distance(at));
  }
  return least;
}

/// Height of the resultant of a landward force whose intensity is `at_low` at the curve's foot and `at_high` at its
/// crest, linear between: integral of y s over that of s, by Simpson's rule, exact for parabolas.
double arm_of(const std::vector<Segment>& faces, const Bounds& bounds, double at_low, double at_high) {
  double force = 0., moment = 0.;
  for (const auto& [a, b] : faces) {
    const double length = a.distance(b);
    for (const auto& [s, weight] : std::array<std::array<double, 2>, 3>{{{0., 1.}, {0.5, 4.}, {1., 1.}}}) {
      const double y = a[1] + s * (b[1] - a[1]);
      const double share = (y - bounds.lowest) / (bounds.highest - bounds.lowest);
      const double part = (at_low + share * (at_high - at_low)) * weight * length / 6.;
      force += part;
      moment += y * part;
    }
  }
  return moment / force;
}

void place_pieces(const FlowCase& by, const std::vector<Segment>& faces, Diagnostics& mistakes, Scene& scene) {
  const Bounds bounds = bounds_of_faces(faces);
  if (bounds.highest - bounds.lowest <= 1e-9 * std::max(1., std::abs(bounds.highest))) {
    mistakes.add(at_key(by.title + ".boundary"),
                 "'" + by.load.boundary + "' is level: a moment cannot be put on it by forces landward",
                 "name the curve of the wall, or give region = \"caisson\"");
    return;
  }
  if (by.flow.top && *by.flow.top > bounds.highest)
    mistakes.add(at_key(by.title + ".origin"),
                 "the water reaches y = " + significant(*by.flow.top, 6) + " m, above the wall '" + by.load.boundary +
                     "', whose crest is at " + significant(bounds.highest, 6) + " m",
                 "a level above the crest is not read: give a higher wall, or pressures");
  const FlowHistory& history = *by.flow.force;
  const FlowPieces pieces = pieces_of(history, arm_of(faces, bounds, 1., 0.), arm_of(faces, bounds, 0., 1.));
  const auto give = [&](const std::string& piece, double at_low, double at_high, const std::vector<double>& force) {
    Load& load = scene.loads.at(by.name + "." + piece);
    load.shape = {{bounds.lowest, at_low}, {bounds.highest, at_high}};
    give_history(history, force, scene.time.end, load);
  };
  give("low", 1., 0., pieces.low);
  give("high", 0., 1., pieces.high);
}

void check_distance(const FlowCase& by, const std::vector<Segment>& faces, Diagnostics& mistakes) {
  const Bounds bounds = bounds_of_faces(faces);
  const double size = std::max(bounds.right - bounds.left, bounds.highest - bounds.lowest);
  const double tolerable = by.flow.source.within.value_or(0.01 * size);
  double most = 0.;
  dealii::Point<dim> farthest;
  for (const auto& [x, y] : by.flow.at) {
    const dealii::Point<dim> at(x, y);
    const double distance = distance_to(faces, at);
    if (distance <= most) continue;
    most = distance;
    farthest = at;
  }
  if (most > tolerable * (1. + 1e-9))
    mistakes.add(at_key(by.title + ".origin"),
                 "a point of the record lies at (" + significant(farthest[0], 6) + ", " + significant(farthest[1], 6) +
                     ") of the scene, " + significant(most) + " m from the boundary '" + by.load.boundary + "'",
                 "give the origin, landward and up that bring it there; or within = " + significant(most, 2) +
                     " (m) or more where it may lie so far");
}

Bounds bounds_of_region(const Mesh& mesh, const std::string& region) {
  Bounds bounds;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell) == region)
      for (const unsigned int v : cell->vertex_indices()) bounds.add(cell->vertex(v));
  return bounds;
}

}  // namespace

NumberedWarnings flow_arm_warnings(const Case& input, const Mesh& mesh) {
  NumberedWarnings list;
  for (const FlowCase* source : sources_of_type<FlowCase>(input)) {
    const FlowCase& by = *source;
    if (!by.flow.force || !by.flow.peak_arm || !by.acts()) continue;
    const bool on_region = by.load.boundary.empty();
    const Bounds bounds =
        on_region ? bounds_of_region(mesh, by.load.region) : bounds_of_faces(faces_of(mesh, by.load.boundary));
    const double y = by.flow.force->centre[1] + *by.flow.peak_arm;
    const double slack = 1e-6 * (bounds.highest - bounds.lowest);
    if (y >= bounds.lowest - slack && y <= bounds.highest + slack) continue;
    list.push_back({"flow_arm_outside", y, y < bounds.lowest ? bounds.lowest : bounds.highest, "m",
                    "'" + by.title + "': the record's largest force acts at y = " + significant(y, 4) + " m, " +
                        (y < bounds.lowest ? "below" : "above") + " '" +
                        (on_region ? by.load.region : by.load.boundary) +
                        "', which reaches from y = " + significant(bounds.lowest, 4) + " to " +
                        significant(bounds.highest, 4) + " m: no pressures on it have such a resultant",
                    "look at the patches, origin, up, and a vertical force whose moment is in the record"});
  }
  return list;
}

void place_flows(const Case& input, const Mesh& mesh, Scene& scene) {
  Diagnostics mistakes;
  for (const FlowCase* source : sources_of_type<FlowCase>(input)) {
    const FlowCase& by = *source;
    if (by.load.boundary.empty()) continue;
    const std::vector<Segment> faces = faces_of(mesh, by.load.boundary);
    if (faces.empty()) continue;  // the scene's checks report it
    if (by.flow.pressure)
      check_distance(by, faces, mistakes);
    else if (!by.flow.force->moment.empty())
      place_pieces(by, faces, mistakes, scene);
  }
  mistakes.throw_if_any();
}

}  // namespace upbead
