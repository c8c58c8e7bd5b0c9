#include "sliding/base_pressure.h"

#include <algorithm>
#include <cmath>

namespace upbead {

EdgePressures edge_pressures(double force, double moment, double width) {
  if (!(force > 0.)) return {};
  const double e = moment / force, least = 1e-3 * width;
  if (std::abs(e) <= width / 6.) return {force / width * (1. - 6. * e / width), force / width * (1. + 6. * e / width)};
  const double edge = 2. * force / (3. * std::max(0.5 * width - std::abs(e), least));
  return e > 0. ? EdgePressures{0., edge} : EdgePressures{edge, 0.};
}

}  // namespace upbead
