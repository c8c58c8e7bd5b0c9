// Stress and pore pressure along the caisson's bottom.
#pragma once

#include <string>
#include <vector>

#include "upbead/fem/caisson.h"

namespace upbead {

/// What the names of these readings begin with.
inline const std::string base_prefix = "base/";

/// Positions x of the middles of the faces of the ground's cells under the caisson, ascending (m).
std::vector<double> base_positions(const Space& space, const Caisson& caisson);

/// At each of them, in the ground just below: "base/I/normal_stress" (change of the effective stress on the bottom,
/// compression positive), "base/I/shear_stress" (on the ground, landward) and, where there is pore water,
/// "base/I/pore_pressure" (Pa), I from 0. Stresses of the elements, without the viscous part of the damping: their
/// integral approaches F_T with the cells, it is not F_T.
std::vector<Reading> base_readings(const Space& space, const Unknowns& unknowns, const Scene& scene,
                                   const Caisson& caisson);

}  // namespace upbead
