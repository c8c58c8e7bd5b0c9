// Whether soil can be at rest under given loads at all, by limit analysis.
#pragma once

#include <functional>
#include <vector>

#include "fem/static_soil.h"

namespace upbead {

/// `none`: no stress within the strength is in equilibrium; `open`: neither was shown.
enum class RestFound { rest, none, open };

struct LimitAnswer {
  RestFound found = RestFound::open;
  PointStresses stresses;    ///< within the strength and in equilibrium, where there is a rest
  Vector moved;              ///< the motion in which the ground fails, or is nearest to that (its length means nothing)
  unsigned shears_most = 0;  ///< active cell where it shears most in that
  std::vector<double> work;  ///< of shearing in that, by active cell index up to the last; any unit
  double factor = 1.;    ///< where there is no rest: about by how much the strength would have to be divided for one
  double residual = 0.;  ///< |forces out of balance| over |loads|
  int iterations = 0;    ///< each with a factorisation
};

/// Seeks the least D for which a stress s is in equilibrium with the loads and within the strength with D added to the
/// cohesion and to the tensile strength of all laws of `soil` (Pa):
///   in the plane, with mean m and radius R of Mohr's circle: R <= c' cos phi' + D - m sin phi', R <= tension + D - m;
/// sigma_zz, between the principal stresses in the plane, sets no limit then. Where D <= 0 is reached, s is a rest.
/// Beside D, `trifle` times the complementary energy of the change from the committed stress is made small. Lagrange's
/// multipliers give a motion, and with it a bound from below, exact for any multipliers (the kinematic theorem): where
/// it is positive, a rest would need 50 times the energy of the committed stress, so there is none. By a primal-dual
/// interior-point method with second-order cones (Nesterov and Todd 1998; of limit analysis: Makrodimopoulos and Martin
/// 2006). `each` is called before every iteration, and may throw.
LimitAnswer seek_rest(const StaticSoil& soil, const Vector& load, const std::function<void()>& each = {});

}  // namespace upbead
