// Readings at points: everything that can be measured there.
#pragma once

#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

#include "fem/unknowns.h"

namespace upbead {

/// A point of the mesh: its cell and the coordinates in it.
struct Location {
  dealii::DoFHandler<dim>::active_cell_iterator cell;
  dealii::Point<dim> unit;
};

/// The cell that holds a point; of several, one with pore water. None outside the mesh.
std::optional<Location> locate(const Space& space, const dealii::Point<dim>& point);

/// Displacement, velocity and acceleration; where there is pore water, pressure, and with inertial flow Darcy velocity;
/// where there is an elastic skeleton or solid, strain and effective stress (tension positive; without the viscous part
/// of the damping). Their group is "probes".
std::vector<Reading> probe_readings(const Space& space, const Unknowns& unknowns, const Scene& scene,
                                    const std::string& name);

}  // namespace upbead
