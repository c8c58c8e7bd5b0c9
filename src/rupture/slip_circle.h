// Safety of a part of the ground that slips on an arc, with what a caisson puts on it: simplified method of Bishop
// (1955), The use of the slip circle in the stability analysis of slopes, Geotechnique 5(1), 7-17.
#pragma once

#include "rupture/slices.h"

namespace upbead {

struct SlipCircle {
  double x = 0., y = 0.;  ///< centre (m)
  double radius = 0.;     ///< m
};

/// Its lower half, as the line below ground that slips that way.
std::function<std::optional<BasePoint>(double x)> arc_of(const SlipCircle& circle, SlipsTo slips);

/// Whether what pushes the base and where its resultant stands (both landward positive) leave it open that the ground
/// slips that way.
bool may_slip(double shear, double moment, SlipsTo slips);

/// F of the part of the section between x = from and x = to, where the circle meets the surface, with about n slices:
/// safety_of(), where the moments about the centre drive.
FigureSafety circle_safety(const GroundSection& section, const GroundLoads& loads, const SlipCircle& circle,
                           SlipsTo slips, double from, double to, int n_slices);

/// The same; the circle meets the surface at the ends of the longest part of its lower half that is below the surface.
FigureSafety circle_safety(const GroundSection& section, const GroundLoads& loads, const SlipCircle& circle,
                           SlipsTo slips, int n_slices);

}  // namespace upbead
