#include "rupture/ground_loads.h"

#include <cmath>

namespace upbead {

std::optional<StripLoad> effective_strip(double force, double moment, double horizontal, double from, double to,
                                         double level) {
  const double eccentricity = moment / force, half = 0.5 * (to - from) - std::abs(eccentricity);
  if (!(force > 0.) || !(half > 0.)) return std::nullopt;
  const double q = 0.5 * force / half;
  return eccentricity > 0. ? StripLoad{to - 2. * half, to, q, q, horizontal, level}
                           : StripLoad{from, from + 2. * half, q, q, horizontal, level};
}

double weight_on(const GroundLoads& loads, double x) {
  const auto& strip = loads.strip;
  if (strip && x >= strip->from && x <= strip->to)
    return strip->at_from + (strip->at_to - strip->at_from) * (x - strip->from) / (strip->to - strip->from);
  return loads.surcharge ? loads.surcharge(x) : 0.;
}

}  // namespace upbead
