// An indicator of where smaller cells would change the plastic flow of the ground.
#pragma once

#include <vector>

#include "fem/static_soil.h"
#include "scenes.h"

namespace upbead::test {

/// For each cell the integral of |sigma| |d eps - mean of d eps| (J/m) in the step `moved`. Zero where the ground
/// moves rigidly or strains uniformly, large along slip lines.
std::vector<double> uneven_flow(const Compiled& compiled, const Vector& moved, const PointStresses& stresses);

/// The smallest set of cells that has `share` of the sum.
std::vector<bool> most_uneven(const std::vector<double>& uneven, double share);

}  // namespace upbead::test
