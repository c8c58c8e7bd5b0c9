// Circles of a family: what stays of them, from a section of the ground.
#pragma once

#include <array>

#include "rupture/slip_circle.h"
#include "upbead/rupture/circle_family.h"

namespace upbead {

/// The circle between x = from and x = to, in n slices of equal width; none where it leaves the section or would cut
/// what may not fail.
std::optional<FamilyCircle> family_circle(const GroundSection& section, const GroundLoads& loads,
                                          const SlipCircle& circle, SlipsTo slips, double from, double to, int n);

/// Where the readings of a slice are taken, and what a pressure on its surface adds to the reading of the moment.
struct SliceReading {
  std::array<double, 2> surface{}, base{};  ///< x, y (m)
  double moment_per_pressure = 0.;          ///< m2
};
std::vector<SliceReading> readings_of(const GroundSection& section, const FamilyCircle& circle);

}  // namespace upbead
