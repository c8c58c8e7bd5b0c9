// What acts on ground that may slip, besides its weight.
#pragma once

#include <functional>
#include <optional>

namespace upbead {

/// Which way the ground slips below its bottom: `right` is to larger x.
enum class SlipsTo { left, right };

/// What a strip puts on the surface: pressures that vary linearly from one end to the other, and a horizontal force.
struct StripLoad {
  double from = 0., to = 0.;        ///< x of its ends (m), from < to
  double at_from = 0., at_to = 0.;  ///< pressure there, vertical (Pa)
  double horizontal = 0.;           ///< N/m, positive to larger x
  double level = 0.;                ///< y at which that acts (m)
};

/// The load of a base on an effective width, over which it is uniform: the resultant stands over the middle of that
/// width (Meyerhof 1953, The bearing capacity of foundations under eccentric and inclined loads). That width ends at
/// the edge to which the resultant is nearer. N' > 0 (N/m), M' about the middle of the base, positive where it moves
/// the resultant to larger x (N m/m); none where the resultant leaves the base.
std::optional<StripLoad> effective_strip(double force, double moment, double horizontal, double from, double to,
                                         double level);

struct GroundLoads {
  std::optional<StripLoad> strip;
  /// Pore pressure at (x, y) (Pa): what is not in the submerged weights. On the surface it presses from outside. Empty:
  /// none.
  std::function<double(double x, double y)> pressure;
  std::function<double(double x)> surcharge;  ///< on the surface outside the strip (Pa); empty: none
  /// Horizontal acceleration over gravity, of the weights of the soils as they are; positive: its force acts to larger
  /// x.
  double acceleration = 0.;
};

/// What stands on the surface at x: the strip, or a surcharge beside it (Pa).
double weight_on(const GroundLoads& loads, double x);

}  // namespace upbead
