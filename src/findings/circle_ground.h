// The ground under a caisson in which slip circles are sought, and what the base presses on it at a moment.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "findings/ground_section.h"
#include "findings/pressure_map.h"
#include "rupture/circle_search.h"

namespace upbead {

using PressureAt = std::function<double(double x, double y)>;  ///< excess pore pressure (Pa); empty: none

/// A moment, and what the base presses on the ground with.
struct BaseMoment {
  std::optional<double> time;                  ///< s; none: at rest
  double force = 0., shear = 0., moment = 0.;  ///< N', F_T (N/m), M' (N m/m)
};

/// The base of the caisson, and the ground in which circles are sought: four widths to each side.
struct CircleGround {
  explicit CircleGround(const Simulation& simulation);

  GroundSection section;
  double left = 0., right = 0., level = 0.;  ///< of the base (m)
  double from = 0., to = 0.;                 ///< ends of the ground where circles may meet its surface (m)
  std::function<double(double)> surcharge;   ///< Pa at x
};

/// What presses on the ground at a moment; none where the resultant leaves the base.
std::optional<GroundLoads> loads_of(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure);

/// All of the ground that leaves the whole strip on the part that slips.
CircleRange range_beside(const CircleGround& ground, const StripLoad& strip);

/// Whether what pushes the base and where its resultant stands leave it open that the ground slips that way.
bool may_slip(const BaseMoment& moment, SlipsTo slips);

/// Points a 40th of the base's width apart.
PointGrid grid_of(const CircleGround& ground);

/// Why circles cannot be sought in a scene; "" where they can, as far as the base is known.
std::string why_no_circles_in(const Simulation& simulation);

}  // namespace upbead
