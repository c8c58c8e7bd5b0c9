// The least factor of each way to fail, under one wave or all waves of a life.
#pragma once

#include <limits>

namespace upbead {

struct WaysToFail {
  static constexpr double never = std::numeric_limits<double>::infinity();

  double sliding = never, sliding_seaward = never;  ///< mu N'/F_T while F_T acts that way
  double overturning = never;                       ///< margin about either edge
  double heel_pressure = 0., toe_pressure = 0.;     ///< largest, in motion (Pa); infinity where the resultant leaves
  double circles = never;                           ///< F by Bishop; 0 where the resultant leaves the base
};

bool operator==(const WaysToFail& a, const WaysToFail& b);

/// The worst of both, way by way.
WaysToFail worst_of(const WaysToFail& a, const WaysToFail& b);

}  // namespace upbead
