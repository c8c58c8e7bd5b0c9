#include "upbead/waves/impulsive.h"

#include <algorithm>
#include <cmath>

namespace upbead {

double alpha_I1(double berm_width_over_wavelength, double mound_height_over_depth) {
  const double x = berm_width_over_wavelength - 0.12, y = mound_height_over_depth - 0.6;
  const double delta_11 = 0.93 * x + 0.36 * y;
  const double delta_22 = -0.36 * x + 0.93 * y;
  const double delta_1 = (delta_11 <= 0. ? 20. : 15.) * delta_11;
  const double delta_2 = (delta_22 <= 0. ? 4.9 : 3.) * delta_22;
  // cosh may be infinite for a very wide berm: the coefficient is then 0, as it should be.
  if (delta_2 <= 0.) return std::cos(delta_2) / std::cosh(delta_1);
  return 1. / (std::cosh(delta_1) * std::sqrt(std::cosh(delta_2)));
}

double alpha_I0(double height, double berm_depth) {
  return std::min(height / berm_depth, 2.);
}

}  // namespace upbead
