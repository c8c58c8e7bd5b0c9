#include "fem/locate.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/mapping_q1.h>

namespace upbead {

using namespace dealii;

std::optional<Point<dim>> unit_coordinates(const Triangulation<dim>::active_cell_iterator& cell,
                                           const Point<dim>& point) {
  if (cell->vertex(0).distance(point) > 1.01 * cell->diameter()) return std::nullopt;  // what is in it is no farther
  try {
    const Point<dim> unit = MappingQ1<dim>().transform_real_to_unit_cell(cell, point);
    if (!GeometryInfo<dim>::is_inside_unit_cell(unit, 1e-9)) return std::nullopt;
    return GeometryInfo<dim>::project_to_unit_cell(unit);
  } catch (const Mapping<dim>::ExcTransformationFailed&) {
    return std::nullopt;  // far outside the mapping of a quadrilateral has no inverse
  }
}

}  // namespace upbead
