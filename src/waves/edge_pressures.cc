#include "upbead/waves/edge_pressures.h"

#include <cmath>
#include <limits>

namespace upbead {

namespace {

/// A resultant as near to an edge as round-off stands on it: the base node by node bears none beyond.
constexpr double round_off = 1e-9;

}  // namespace

EdgePressures edge_pressures(double force, double moment, double width) {
  if (!(force > 0. && std::abs(moment) < 0.5 * width * force * (1. - round_off))) {
    EdgePressures p{0., 0.};
    if (moment >= 0. || force <= 0.) p.landward.reset();  // off the ground, it may come down on either edge
    if (moment <= 0. || force <= 0.) p.seaward.reset();
    return p;
  }
  const double e = moment / force;
  if (std::abs(e) <= width / 6.) return {force / width * (1. - 6. * e / width), force / width * (1. + 6. * e / width)};
  const double edge = 2. * force / (3. * (0.5 * width - std::abs(e)));
  return e > 0. ? EdgePressures{0., edge} : EdgePressures{edge, 0.};
}

double above_all(const std::optional<double>& pressure) {
  return pressure.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace upbead
