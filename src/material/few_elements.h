// A backbone of few points instead of many.
#pragma once

#include <vector>

#include "material/hysteretic_law.h"

namespace upbead {

/// The fewest points, about 27 for a hyperbola, whose overlay has the energy per cycle, stress and damping ratio of the
/// overlay through the given points within 2 %, at all amplitudes from a damping ratio of 0.4 % (gamma_r/50 of a
/// hyperbola) on, and the same strength; G: the small-strain modulus (Pa). The given points where nothing is gained.
std::vector<BackbonePoint> with_few_elements(double G, const std::vector<BackbonePoint>& points);

}  // namespace upbead
