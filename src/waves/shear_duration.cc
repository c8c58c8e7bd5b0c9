#include "upbead/waves/shear_duration.h"

#include <algorithm>
#include <cmath>

namespace upbead {

double standing_duration(double height, double depth, double period) {
  return (0.5 - std::min(height / depth, 0.8) / 8.) * period;
}

double DurationFactor::operator()(double alpha_star) const {
  return 1. / std::pow(std::pow(std::max(alpha_star, 0.), a) + 1., b);
}

}  // namespace upbead
