// Readings at points: all quantities that exist there.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fem/unknowns.h"

namespace upbead {

/// Displacement, velocity and acceleration; where there is pore water, pressure, and with inertial flow Darcy
/// velocity; where there is a skeleton or solid that deforms, strain and effective stress (tension positive; without
/// the viscous part of the damping). The stress is the elastic one; for soil that yields see followed_readings(). The
/// group of these readings is "probes".
std::vector<Reading> probe_readings(const Space& space, const Unknowns& unknowns, const Scene& scene,
                                    const std::string& name);

/// Excess pore pressure at a place of a cell, coordinates in the unit cell: its factor of each unknown's velocity.
std::map<int, double> pressure_row(const Unknowns& unknowns, const Cell& cell, const dealii::Point<dim>& unit);

/// Readings of stress at a point of soil that yields; their rows give only the elastic stress.
struct FollowedReading {
  Cell cell;
  dealii::Point<dim> unit;                                                  ///< coordinates in the unit cell
  std::vector<std::pair<ReadingName, double PlaneStress::*>> components{};  ///< each reading with its component
};

/// Such readings for the probes of a scene that lie in soil that yields.
std::vector<FollowedReading> followed_readings(const Space& space, const Scene& scene);

}  // namespace upbead
