// Whether soil can be at rest under given loads at all.
#pragma once

#include <functional>

#include "fem/static_soil.h"

namespace upbead {

/// `none`: no stress within the strength is in equilibrium; `open`: neither was shown.
enum class RestFound { rest, none, open };

struct LimitAnswer {
  RestFound found = RestFound::open;
  Vector x;      ///< displacements; in equilibrium where there is a rest
  Vector moved;  ///< last change of x: where there is no rest, the motion in which the ground fails
  double residual = 0.;  ///< |forces out of balance| over |loads|
  /// Where there is no rest: what resists shear in that motion, over what would have to.
  double resisting = 1.;
  int iterations = 0;  ///< each with a factorisation
};

/// Seeks the stress that is within the strength, in equilibrium with the loads, and nearest to the start by its
/// complementary energy. The laws of `soil` must be associated, and its committed state without strain. Then this
/// stress belongs to the least value of the convex function
///   P(x) = integral of (sigma : eps - (sigma - sigma_0) : D^-1 : (sigma - sigma_0) / 2) - load . x,
/// whose gradient is what is out of balance (Moreau 1976); which x the search begins with does not change it. As -P(x)
/// of any x is less than the energy of every change of stress that leads to a rest, there is none that the soil could
/// reach where -P has grown to `most_energy` times the energy of the stress at the start.
/// `each` is called before every iteration, and may throw.
LimitAnswer seek_rest(StaticSoil& soil, const Vector& load, Vector begin, const std::function<void()>& each = {});

}  // namespace upbead
