// Readings at points: everything that can be measured there.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fem/unknowns.h"

namespace upbead {

/// Displacement, velocity and acceleration; where there is pore water, pressure, and with inertial flow Darcy velocity;
/// where there is a skeleton or solid that deforms, strain and effective stress (tension positive; without the viscous
/// part of the damping), the elastic one: see followed_readings(). Their group is "probes".
std::vector<Reading> probe_readings(const Space& space, const Unknowns& unknowns, const Scene& scene,
                                    const std::string& name);

/// Readings of stress at a point of soil that yields, where their rows tell the elastic stress alone.
struct FollowedReading {
  Cell cell;
  dealii::Point<dim> unit;                                                  ///< coordinates in it
  std::vector<std::pair<ReadingName, double PlaneStress::*>> components{};  ///< the reading of each
};

/// Those of the probes of a scene that lie in soil that yields.
std::vector<FollowedReading> followed_readings(const Space& space, const Scene& scene);

}  // namespace upbead
