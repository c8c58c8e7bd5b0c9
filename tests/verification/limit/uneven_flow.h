// Where smaller cells would change how ground flows.
#pragma once

#include <vector>

#include "fem/static_soil.h"
#include "scenes.h"

namespace upbead::test {

/// Of each cell the integral of |sigma| |d eps - its mean| (J/m) in the step `moved`. Nothing where the ground moves as
/// one or strains alike, much along lines on which it slides.
std::vector<double> uneven_flow(const Compiled& compiled, const Vector& moved, const PointStresses& stresses);

/// The fewest cells that have `share` of the sum.
std::vector<bool> most_uneven(const std::vector<double>& uneven, double share);

}  // namespace upbead::test
