#include "fem/outline.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>

#include "upbead/model/scene.h"

namespace upbead {

using namespace dealii;

void Bounds::add(const Point<dim>& point) {
  left = std::min(left, point[0]);
  right = std::max(right, point[0]);
  lowest = std::min(lowest, point[1]);
  highest = std::max(highest, point[1]);
}

Names Outline::touching(const std::string& surface) const {
  Names names;
  for (const auto& [a, b] : contacts) {
    if (a == surface) names.insert(b);
    if (b == surface) names.insert(a);
  }
  return names;
}

namespace {

using MeshCell = Triangulation<dim>::active_cell_iterator;

/// Height of the middle of a cell's lowest side.
double lower_side(const MeshCell& cell) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& face : cell->face_iterators()) lowest = std::min(lowest, face->center()[1]);
  return lowest;
}

void add_inner_face(const Mesh& mesh, const MeshCell& cell, unsigned f, Outline& outline) {
  const std::string &surface = mesh.surface_of(cell), &other = mesh.surface_of(cell->neighbor(f));
  if (surface == other) return;
  outline.contacts.insert(std::minmax(surface, other));
  if (const std::string& curve = mesh.curve_of(cell->face(f)); !curve.empty())
    outline.inner[curve].insert(std::minmax(surface, other));
  if (surface == caisson_name && cell->face(f)->center()[1] > lower_side(cell) + 1e-9 * cell->diameter())
    outline.beside_caisson.insert(other);
}

}  // namespace

Outline outline_of(const Mesh& mesh) {
  Outline outline;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    for (const unsigned v : cell->vertex_indices()) outline.surfaces[mesh.surface_of(cell)].add(cell->vertex(v));
    for (const unsigned f : cell->face_indices()) {
      if (!cell->at_boundary(f)) {
        add_inner_face(mesh, cell, f, outline);
        continue;
      }
      OuterCurve& curve = outline.outer[mesh.curve_of(cell->face(f))];
      curve.surfaces.insert(mesh.surface_of(cell));
      for (unsigned v = 0; v < 2; ++v) curve.bounds.add(cell->face(f)->vertex(v));
    }
  }
  return outline;
}

std::map<std::string, std::set<std::string>> far_sides(const Mesh& mesh) {
  std::map<std::string, std::set<std::string>> sides;
  for (const auto& [name, curve] : outline_of(mesh).outer) {
    const Bounds& bounds = curve.bounds;
    const bool upright = bounds.right - bounds.left < 1e-6 * (bounds.highest - bounds.lowest);
    if (upright && curve.surfaces.count(caisson_name) == 0) sides[name] = curve.surfaces;
  }
  return sides;
}

std::optional<Point<dim>> unit_coordinates(const Triangulation<dim>::active_cell_iterator& cell,
                                           const Point<dim>& point) {
  // a point in the cell is not farther away
  if (cell->vertex(0).distance(point) > 1.01 * cell->diameter()) return std::nullopt;
  try {
    const Point<dim> unit = MappingQ1<dim>().transform_real_to_unit_cell(cell, point);
    if (!GeometryInfo<dim>::is_inside_unit_cell(unit, 1e-9)) return std::nullopt;
    return GeometryInfo<dim>::project_to_unit_cell(unit);
  } catch (const Mapping<dim>::ExcTransformationFailed&) {
    return std::nullopt;  // the mapping of a quadrilateral has no inverse far outside the cell
  }
}

}  // namespace upbead
