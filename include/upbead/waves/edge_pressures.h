// The effective pressures of the two edges of a caisson's bottom.
#pragma once

#include <optional>

namespace upbead {

/// Pa; none where the resultant leaves the bottom there, or nothing presses on it. Everywhere, such a pressure has this
/// one representation: none, null in files; where an order is needed it is above all numbers.
struct EdgePressures {
  std::optional<double> seaward, landward;
};

/// Of a bottom of width B (m) under `force` N' (N/m) and `moment` M' about its middle (N m/m, overturning landward
/// positive), stress varying linearly over the width in contact: N'/B (1 -+ 6 e/B) where |e| = |M'/N'| <= B/6, else 0
/// and 2 N'/(3 t), t = B/2 - |e| > 0 (the bearing pressure p_e of Goda, Random Seas and Design of Maritime Structures,
/// ch. 4). Where t <= 0 there is none on the side to which M' turns the caisson, and 0 on the other; where N' <= 0 it
/// is off the ground, may come down on either, and there is none on both.
EdgePressures edge_pressures(double force, double moment, double width);

/// The number, or one above all numbers where there is none.
double above_all(const std::optional<double>& pressure);

}  // namespace upbead
