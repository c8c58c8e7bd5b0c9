// Where a point lies in a mesh.
#pragma once

#include <deal.II/base/point.h>

#include <optional>

#include "upbead/mesh/mesh.h"

namespace upbead {

/// Coordinates of a point in the unit cell; none where it lies outside the cell. On its rim counts as inside.
std::optional<dealii::Point<dim>> unit_coordinates(const dealii::Triangulation<dim>::active_cell_iterator& cell,
                                                   const dealii::Point<dim>& point);

}  // namespace upbead
